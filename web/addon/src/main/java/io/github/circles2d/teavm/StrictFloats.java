package io.github.circles2d.teavm;

import org.teavm.backend.javascript.TeaVMJavaScriptHost;
import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.MethodReference;
import org.teavm.model.Program;
import org.teavm.model.Variable;
import org.teavm.model.instructions.BinaryInstruction;
import org.teavm.model.instructions.BinaryOperation;
import org.teavm.model.instructions.CastNumberInstruction;
import org.teavm.model.instructions.FloatConstantInstruction;
import org.teavm.model.instructions.InvocationType;
import org.teavm.model.instructions.InvokeInstruction;
import org.teavm.model.instructions.NumericOperandType;
import org.teavm.vm.spi.TeaVMHost;
import org.teavm.vm.spi.TeaVMPlugin;

/**
 * Makes numbers those of Java if the target is JavaScript: TeaVM computes floats as doubles there, lets casts to whole numbers wrap, and
 * writes {@code a + (b - c)} of doubles without its brackets, which rounds otherwise. Every float operation of the game and the library
 * is rounded, and what is added to or multiplied with a double stands in brackets. It does nothing if the target is WebAssembly, whose
 * numbers are those of Java. TeaVM finds it as a service.
 */
public final class StrictFloats implements TeaVMPlugin, ClassHolderTransformer {
    private static final MethodReference ROUND = new MethodReference(Floats.class, "round", float.class, float.class);
    private static final MethodReference IN_BRACKETS =
            new MethodReference(Floats.class, "inBrackets", double.class, double.class);
    private static final MethodReference OF_LONG = new MethodReference(Floats.class, "ofLong", long.class, float.class);
    private static final MethodReference TO_INT = new MethodReference(Floats.class, "toInt", double.class, int.class);
    private static final MethodReference TO_LONG =
            new MethodReference(Floats.class, "toLong", double.class, long.class);

    /** TeaVM makes it. */
    public StrictFloats() {}

    @Override
    public void install(TeaVMHost host) {
        if (host.getExtension(TeaVMJavaScriptHost.class) != null) {
            host.add(this);
        }
    }

    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        if (isOfTheSystem(type.getName())) {
            return;
        }
        for (MethodHolder method : type.getMethods()) {
            Program program = method.getProgram();
            if (program != null) {
                transform(program);
            }
        }
    }

    private static boolean isOfTheSystem(String name) {
        return name.startsWith("java.")
                || name.startsWith("javax.")
                || name.startsWith("org.teavm.")
                || name.equals(Floats.class.getName());
    }

    private static void transform(Program program) {
        for (BasicBlock block : program.getBasicBlocks()) {
            Instruction instruction = block.getFirstInstruction();
            while (instruction != null) {
                Instruction next = instruction.getNext();
                transform(program, instruction);
                instruction = next;
            }
        }
    }

    private static void transform(Program program, Instruction instruction) {
        if (instruction instanceof BinaryInstruction binary && isFloat(binary)) {
            Variable result = binary.getReceiver();
            Variable exact = program.createVariable();
            binary.setReceiver(exact);
            binary.insertNext(call(ROUND, exact, result, binary));
        } else if (instruction instanceof BinaryInstruction binary && losesBrackets(binary)) {
            Variable bare = binary.getSecondOperand();
            Variable inBrackets = program.createVariable();
            binary.setSecondOperand(inBrackets);
            binary.insertPrevious(call(IN_BRACKETS, bare, inBrackets, binary));
        } else if (instruction instanceof FloatConstantInstruction constant
                && !isWrittenExactly(constant.getConstant())) {
            Variable result = constant.getReceiver();
            Variable written = program.createVariable();
            constant.setReceiver(written);
            constant.insertNext(call(ROUND, written, result, constant));
        } else if (instruction instanceof CastNumberInstruction cast) {
            MethodReference method = conversion(cast);
            if (method != null) {
                cast.replace(call(method, cast.getValue(), cast.getReceiver(), cast));
            }
        }
    }

    private static boolean isFloat(BinaryInstruction binary) {
        return binary.getOperandType() == NumericOperandType.FLOAT
                && binary.getOperation() != BinaryOperation.COMPARE_GREATER
                && binary.getOperation() != BinaryOperation.COMPARE_LESS;
    }

    private static boolean losesBrackets(BinaryInstruction binary) {
        return binary.getOperandType() == NumericOperandType.DOUBLE
                && (binary.getOperation() == BinaryOperation.ADD || binary.getOperation() == BinaryOperation.MULTIPLY);
    }

    /** Whether the shortest decimal of a float, which TeaVM writes, is the same number as a double. */
    private static boolean isWrittenExactly(float value) {
        return Float.isNaN(value) || value == Double.parseDouble(Float.toString(value));
    }

    /** The method for a cast; null for one that JavaScript does right. */
    private static MethodReference conversion(CastNumberInstruction cast) {
        NumericOperandType from = cast.getSourceType();
        boolean fromFloating = from == NumericOperandType.FLOAT || from == NumericOperandType.DOUBLE;
        return switch (cast.getTargetType()) {
            case FLOAT -> from == NumericOperandType.LONG ? OF_LONG : ROUND;
            case INT -> fromFloating ? TO_INT : null;
            case LONG -> fromFloating ? TO_LONG : null;
            case DOUBLE -> null;
        };
    }

    private static Instruction call(MethodReference method, Variable argument, Variable result, Instruction at) {
        InvokeInstruction call = new InvokeInstruction();
        call.setType(InvocationType.SPECIAL);
        call.setMethod(method);
        call.setArguments(argument);
        call.setReceiver(result);
        call.setLocation(at.getLocation());
        return call;
    }
}
