package io.github.circles2d.project;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.xpath.XPath;
import javax.xml.xpath.XPathConstants;
import javax.xml.xpath.XPathExpressionException;
import javax.xml.xpath.XPathFactory;
import org.w3c.dom.Document;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;
import org.xml.sax.helpers.DefaultHandler;

/**
 * The bundle of a release, in a folder, and what the central repository asks of it. {@code .ci/release-dry-run} runs this as a
 * program of a single file; it verifies the signatures itself.
 */
final class ReleaseBundle {
    private static final List<String> ENDINGS = List.of(".pom", ".jar", "-sources.jar", "-javadoc.jar");
    private static final List<String> ASKED_OF_A_POM = List.of(
            "name",
            "description",
            "url",
            "licenses/license/name",
            "licenses/license/url",
            "developers/developer/name",
            "developers/developer/email",
            "scm/connection",
            "scm/developerConnection",
            "scm/url");

    private final Path folder;
    private final List<String> problems = new ArrayList<>();

    private ReleaseBundle(Path folder) {
        this.folder = folder;
    }

    /** Arguments: the folder, the version, and the artifacts of the group {@code io.github.circles2d}. */
    public static void main(String[] arguments) throws IOException {
        List<String> artifacts = List.of(arguments).subList(2, arguments.length);
        List<String> problems = problems(Path.of(arguments[0]), arguments[1], artifacts);
        problems.forEach(System.err::println);
        if (!problems.isEmpty()) {
            System.exit(1);
        }
    }

    /** Returns what the central repository would refuse, a line each. */
    static List<String> problems(Path folder, String version, List<String> artifacts) throws IOException {
        ReleaseBundle bundle = new ReleaseBundle(folder);
        bundle.check(version, artifacts);
        return bundle.problems;
    }

    private void check(String version, List<String> artifacts) throws IOException {
        if (version.endsWith("-SNAPSHOT")) {
            problems.add(version + " is a snapshot");
        }
        Set<Path> expected = new TreeSet<>();
        for (String artifact : artifacts) {
            String place = "io/github/circles2d/" + artifact + "/" + version + "/" + artifact + "-" + version;
            for (String ending : ENDINGS) {
                for (String addition : new String[] {"", ".asc", ".md5", ".sha1"}) {
                    expected.add(folder.resolve(place + ending + addition));
                }
            }
        }
        Set<Path> given = files(folder);
        expected.stream()
                .filter(file -> !given.contains(file))
                .forEach(file -> problems.add(name(file) + " is missing"));
        for (Path file : given) {
            String name = name(file);
            if (!expected.contains(file)) {
                problems.add(name + " is not expected");
            } else if (name.endsWith(".md5")) {
                checkSum(file, "MD5");
            } else if (name.endsWith(".sha1")) {
                checkSum(file, "SHA-1");
            } else if (name.endsWith(".pom")) {
                checkPom(file, version);
            } else if (name.endsWith(".jar")) {
                checkJar(file, version);
            }
        }
    }

    private String name(Path file) {
        return folder.relativize(file).toString().replace('\\', '/');
    }

    private static Set<Path> files(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            return all.filter(Files::isRegularFile).collect(Collectors.toCollection(TreeSet::new));
        }
    }

    private void checkSum(Path file, String algorithm) throws IOException {
        String name = file.toString();
        Path of = Path.of(name.substring(0, name.lastIndexOf('.')));
        if (Files.exists(of)
                && !Files.readString(file)
                        .equals(HexFormat.of().formatHex(digest(algorithm, Files.readAllBytes(of))))) {
            problems.add(name(file) + " is not the sum of its file");
        }
    }

    private static byte[] digest(String algorithm, byte[] bytes) {
        try {
            return MessageDigest.getInstance(algorithm).digest(bytes);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    private void checkPom(Path file, String version) throws IOException {
        String text = Files.readString(file);
        for (String unwanted : new String[] {"${", "-SNAPSHOT", "<parent>", "<repositories>", "<scope>test</scope>"}) {
            if (text.contains(unwanted)) {
                problems.add(name(file) + " has " + unwanted);
            }
        }
        try (InputStream in = Files.newInputStream(file)) {
            DocumentBuilder builder = DocumentBuilderFactory.newInstance().newDocumentBuilder();
            builder.setErrorHandler(new DefaultHandler()); // prints nothing
            Document pom = builder.parse(in);
            XPath paths = XPathFactory.newInstance().newXPath();
            for (String asked : ASKED_OF_A_POM) {
                if (paths.evaluate("/project/" + asked, pom).isBlank()) {
                    problems.add(name(file) + " lacks " + asked);
                }
            }
            String artifact = file.getParent().getParent().getFileName().toString();
            String own =
                    paths.evaluate("concat(/project/groupId, ':', /project/artifactId, ':', /project/version)", pom);
            if (!own.equals("io.github.circles2d:" + artifact + ":" + version)) {
                problems.add(name(file) + " is that of " + own);
            }
            NodeList bare = (NodeList) paths.evaluate("//dependency[not(version)]", pom, XPathConstants.NODESET);
            if (bare.getLength() > 0) {
                problems.add(name(file) + " has a dependency without a version");
            }
        } catch (ParserConfigurationException | SAXException | XPathExpressionException e) {
            problems.add(name(file) + " cannot be read: " + e.getMessage());
        }
    }

    private void checkJar(Path file, String version) throws IOException {
        try (JarFile jar = new JarFile(file.toFile())) {
            String name = name(file);
            if (name.endsWith("-javadoc.jar")) {
                require(jar, file, "index.html");
            } else if (name.endsWith("-sources.jar")) {
                try (JarFile classes =
                        new JarFile(name(file, "-sources.jar", ".jar").toFile())) {
                    sourcesOf(classes).forEach(source -> require(jar, file, source));
                } catch (IOException e) {
                    problems.add(name + " has no readable classes beside it");
                }
            } else {
                require(jar, file, "META-INF/LICENSE");
                if (sourcesOf(jar).isEmpty()) {
                    problems.add(name + " has no class");
                }
            }
            jar.stream()
                    .filter(entry -> entry.getName().matches("META-INF/MANIFEST.MF|META-INF/maven/.*|.*/version.txt"))
                    .filter(entry -> text(jar, entry.getName()).contains("-SNAPSHOT"))
                    .forEach(entry -> problems.add(name + " has -SNAPSHOT in " + entry.getName()));
        }
    }

    private static Path name(Path file, String ending, String other) {
        String name = file.toString();
        return Path.of(name.substring(0, name.length() - ending.length()) + other);
    }

    private void require(JarFile jar, Path file, String entry) {
        if (jar.getEntry(entry) == null) {
            problems.add(name(file) + " lacks " + entry);
        }
    }

    /** The source files of classes, those inside others apart. */
    private static List<String> sourcesOf(JarFile jar) {
        return jar.stream()
                .map(entry -> entry.getName())
                .filter(name -> name.endsWith(".class") && !name.contains("$") && !name.endsWith("-info.class"))
                .map(name -> name.replaceAll("\\.class$", ".java"))
                .toList();
    }

    private static String text(JarFile jar, String entry) {
        try (InputStream in = jar.getInputStream(jar.getEntry(entry))) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
