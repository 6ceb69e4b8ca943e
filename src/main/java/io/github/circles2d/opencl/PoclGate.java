package io.github.circles2d.opencl;

import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Keeps the OpenCL loader from loading POCL if POCL lacks what it needs, and leaves the other drivers as they are. The loader reads
 * where drivers are registered once, so this is called once, before the loader is.
 */
final class PoclGate {
    /** The name of POCL's platform, in every version. */
    static final String PLATFORM = "Portable Computing Language";

    private static final System.Logger LOG = System.getLogger(PoclGate.class.getName());

    private static final File REGISTRATIONS = new File("/etc/OpenCL/vendors");

    private static volatile String refusal;

    private PoclGate() {}

    /** Returns why POCL is not used, and what to do; empty if POCL is used, or is not there. */
    static Optional<String> refusal() {
        return Optional.ofNullable(refusal);
    }

    /**
     * Examines POCL, if it is registered, and hides it from the loader if it lacks something.
     *
     * @param folders where libraries lie
     * @throws OpenClUnavailableException if POCL lacks something and there is no other driver, or POCL cannot be hidden
     */
    static void examine(List<Path> folders) {
        Map<File, String> drivers = registered(System.getenv());
        Optional<String> pocl =
                drivers.values().stream().filter(PoclGate::isPocl).findFirst();
        if (pocl.isEmpty()) {
            return;
        }
        PoclProbe probe = new PoclProbe(
                System.getenv(), new File("/"), Runtime.getRuntime().availableProcessors());
        Optional<String> complaint = probe.complaint(library(pocl.get(), folders));
        if (complaint.isEmpty()) {
            return;
        }
        refusal = "POCL, the OpenCL driver of the CPU, is not used, because it may end this process: " + complaint.get()
                + ".";
        LOG.log(Level.DEBUG, refusal);
        drivers.values().removeIf(PoclGate::isPocl);
        if (drivers.isEmpty() || !hide(drivers)) {
            throw new OpenClUnavailableException(refusal);
        }
    }

    /**
     * Reads which drivers the loader would load.
     *
     * @param environment the environment of the process
     * @return the names of their libraries, by the file that registers them
     */
    static Map<File, String> registered(Map<String, String> environment) {
        String named = environment.getOrDefault("OCL_ICD_VENDORS", "");
        File place = named.isEmpty() ? REGISTRATIONS : new File(named);
        File[] files = place.listFiles((folder, name) -> name.endsWith(".icd"));
        Map<File, String> drivers = new LinkedHashMap<>();
        if (files != null) {
            for (File file : files) {
                drivers.put(file, firstLine(file));
            }
        } else if (!named.endsWith(".icd")) {
            drivers.put(place, named); // a library
        } else {
            File file = place.exists() ? place : new File(REGISTRATIONS, named);
            drivers.put(file, firstLine(file));
        }
        return drivers;
    }

    private static String firstLine(File file) {
        return PoclProbe.content(file).lines().findFirst().orElse("").trim();
    }

    private static boolean isPocl(String library) {
        return new File(library).getName().contains("pocl");
    }

    private static Optional<File> library(String name, List<Path> folders) {
        if (name.contains("/")) {
            return Optional.of(new File(name));
        }
        return folders.stream()
                .map(folder -> folder.resolve(name).toFile())
                .filter(File::exists)
                .findFirst();
    }

    /** Registers the other drivers in a folder of their own and lets the loader look there. It looks when it is called first. */
    private static boolean hide(Map<File, String> others) {
        try {
            Path folder = Files.createTempDirectory("circles2d-drivers");
            List<File> created = new ArrayList<>(List.of(folder.toFile()));
            for (Map.Entry<File, String> driver : others.entrySet()) {
                File copy = folder.resolve(driver.getKey().getName()).toFile();
                try (FileOutputStream out = new FileOutputStream(copy)) {
                    out.write((driver.getValue() + "\n").getBytes(StandardCharsets.ISO_8859_1));
                }
                created.add(copy);
            }
            created.forEach(File::deleteOnExit); // the last is deleted first
            StandardC.setEnvironment("OCL_ICD_VENDORS", folder.toString());
            return true;
        } catch (IOException e) {
            return false;
        }
    }
}
