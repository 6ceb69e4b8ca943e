package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLProgram;
import java.lang.reflect.Field;
import java.util.AbstractList;

/**
 * Keeps JavaCL from passing a folder for included files to the compiler. JavaCL makes a new folder for each program and gives its
 * path without quotes: compilers do not take a path with blanks, and POCL's cache, whose key contains the options, never finds a
 * program again. Sources that {@link KernelSource} puts together include no files.
 */
final class NoIncludes extends AbstractList<String> {
    private static final NoIncludes LIST = new NoIncludes();

    private NoIncludes() {}

    /** Must be called before the program is built. JavaCL has no setting for this, so its field is set. */
    static void of(CLProgram program) {
        try {
            Field includes = CLProgram.class.getDeclaredField("includes");
            includes.setAccessible(true);
            includes.set(program, LIST);
        } catch (ReflectiveOperationException | RuntimeException e) {
            throw new OpenClException("this version of JavaCL cannot be kept from including files (" + e + ")", e);
        }
    }

    @Override
    public String get(int index) {
        throw new IndexOutOfBoundsException(index);
    }

    @Override
    public int size() {
        return 0;
    }

    @Override
    public boolean add(String folder) {
        return false;
    }
}
