package io.github.circles2d;

import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.util.Set;
import net.bytebuddy.jar.asm.ClassReader;
import net.bytebuddy.jar.asm.ClassVisitor;
import net.bytebuddy.jar.asm.ClassWriter;
import net.bytebuddy.jar.asm.Handle;
import net.bytebuddy.jar.asm.MethodVisitor;
import net.bytebuddy.jar.asm.Opcodes;

/**
 * Loads the library, and tests that use it, again, so that each allocation in the library asks {@link AllocationLimit} first. Calls of the JDK
 * that allocate, such as copies of arrays, count as one each.
 */
final class AllocationLimitLoader extends ClassLoader {
    private static final String OURS = "io.github.circles2d.";
    private static final String LIMIT = AllocationLimit.class.getName();
    private static final int API = Opcodes.ASM9;

    /** Methods of the JDK that allocate, whatever class has them. */
    private static final Set<String> ALLOCATING = Set.of(
            "copyOf",
            "copyOfRange",
            "clone",
            "allocate",
            "allocateDirect",
            "asFloatBuffer",
            "asReadOnlyBuffer",
            "duplicate",
            "slice",
            "wrap",
            "toString");

    /** Methods that make a class what it is. One that fails ends the class for good, whoever has been the first to use it. */
    private static final Set<String> INITIAL = Set.of("<clinit>", "$values");

    private final URL library =
            World.class.getProtectionDomain().getCodeSource().getLocation();

    AllocationLimitLoader() {
        super(AllocationLimitLoader.class.getClassLoader());
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        if (!name.startsWith(OURS) || name.equals(LIMIT)) {
            return super.loadClass(name, resolve);
        }
        synchronized (getClassLoadingLock(name)) {
            Class<?> loaded = findLoadedClass(name);
            return loaded != null ? loaded : define(name);
        }
    }

    private Class<?> define(String name) throws ClassNotFoundException {
        String file = name.replace('.', '/') + ".class";
        URL url = getParent().getResource(file);
        if (url == null) {
            throw new ClassNotFoundException(name);
        }
        try (InputStream in = url.openStream()) {
            byte[] code = in.readAllBytes();
            if (url.toString().contains(library.getPath())) {
                code = asking(code);
            }
            return defineClass(name, code, 0, code.length);
        } catch (IOException e) {
            throw new ClassNotFoundException(name, e);
        }
    }

    private static byte[] asking(byte[] code) {
        ClassReader reader = new ClassReader(code);
        ClassWriter writer = new ClassWriter(reader, 0);
        reader.accept(
                new ClassVisitor(API, writer) {
                    @Override
                    public MethodVisitor visitMethod(
                            int access, String name, String descriptor, String signature, String[] exceptions) {
                        MethodVisitor to = super.visitMethod(access, name, descriptor, signature, exceptions);
                        return INITIAL.contains(name) ? to : new Asking(to);
                    }
                },
                0);
        return writer.toByteArray();
    }

    /** Puts a call before each allocation. */
    private static final class Asking extends MethodVisitor {
        Asking(MethodVisitor to) {
            super(API, to);
        }

        private void ask() {
            super.visitMethodInsn(Opcodes.INVOKESTATIC, LIMIT.replace('.', '/'), "allocate", "()V", false);
        }

        @Override
        public void visitTypeInsn(int opcode, String type) {
            if (opcode == Opcodes.ANEWARRAY) {
                ask();
            }
            super.visitTypeInsn(opcode, type);
            if (opcode == Opcodes.NEW) {
                ask(); // behind it: frames name the place of the instruction itself
            }
        }

        @Override
        public void visitIntInsn(int opcode, int operand) {
            if (opcode == Opcodes.NEWARRAY) {
                ask();
            }
            super.visitIntInsn(opcode, operand);
        }

        @Override
        public void visitMultiANewArrayInsn(String descriptor, int dimensions) {
            ask();
            super.visitMultiANewArrayInsn(descriptor, dimensions);
        }

        @Override
        public void visitMethodInsn(int opcode, String owner, String name, String descriptor, boolean isInterface) {
            if ((owner.startsWith("java/") || owner.startsWith("[")) && ALLOCATING.contains(name)) {
                ask();
            }
            super.visitMethodInsn(opcode, owner, name, descriptor, isInterface);
        }

        /** Functions that capture something, and strings that are put together. */
        @Override
        public void visitInvokeDynamicInsn(String name, String descriptor, Handle bootstrap, Object... arguments) {
            if (!descriptor.startsWith("()")) {
                ask();
            }
            super.visitInvokeDynamicInsn(name, descriptor, bootstrap, arguments);
        }
    }
}
