package io.github.circles2d.project;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;

/**
 * Stands in for the portal of the central repository in a dry run: it takes the bundle that Maven sends, and publishes nothing.
 * {@code .ci/release-dry-run} runs it as a program of a single file.
 */
final class DryPortal {
    private static final String API = "/api/v1/publisher/";

    private DryPortal() {}

    /**
     * Argument: a folder, in which a file {@code port} names the port when the portal is ready. What is sent to
     * {@code http://127.0.0.1:PORT/NAME} is unpacked into the folder {@code NAME} there.
     */
    public static void main(String[] arguments) throws IOException {
        Path folder = Path.of(arguments[0]);
        HttpServer server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.createContext("/", exchange -> answer(exchange, folder));
        server.start();
        Path port = folder.resolve("port");
        Files.writeString(folder.resolve("port.tmp"), "" + server.getAddress().getPort());
        Files.move(folder.resolve("port.tmp"), port, StandardCopyOption.ATOMIC_MOVE);
    }

    private static void answer(HttpExchange exchange, Path folder) throws IOException {
        try (exchange) {
            byte[] sent = exchange.getRequestBody().readAllBytes();
            String path = exchange.getRequestURI().getPath();
            int end = path.indexOf(API);
            String name = end < 0 ? "" : path.substring(1, end);
            String call = end < 0 ? "" : path.substring(end + API.length());
            if (!name.matches("\\w+")) {
                reply(exchange, 404, "");
            } else if (call.equals("upload")) {
                unpack(zip(sent), folder.resolve(name));
                reply(exchange, 201, "dry-run");
            } else if (call.equals("status")) {
                reply(exchange, 200, "{\"deploymentId\":\"dry-run\",\"deploymentState\":\"VALIDATED\"}");
            } else {
                reply(exchange, 404, "");
            }
        }
    }

    private static void reply(HttpExchange exchange, int status, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        exchange.sendResponseHeaders(status, bytes.length == 0 ? -1 : bytes.length);
        exchange.getResponseBody().write(bytes);
    }

    /** The zip is the only part of the form; behind it an unzipper sees nothing. */
    private static byte[] zip(byte[] form) throws IOException {
        for (int i = 0; i + 4 <= form.length; i++) {
            if (form[i] == 'P' && form[i + 1] == 'K' && form[i + 2] == 3 && form[i + 3] == 4) {
                return Arrays.copyOfRange(form, i, form.length);
            }
        }
        throw new IOException("there is no zip in what was sent");
    }

    private static void unpack(byte[] zip, Path folder) throws IOException {
        try (ZipInputStream in = new ZipInputStream(new ByteArrayInputStream(zip))) {
            for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
                Path file = folder.resolve(entry.getName()).normalize();
                if (!file.startsWith(folder)) {
                    throw new IOException(entry.getName() + " is outside of the bundle");
                }
                if (!entry.isDirectory()) {
                    Files.createDirectories(file.getParent());
                    Files.write(file, in.readAllBytes());
                }
            }
        }
    }
}
