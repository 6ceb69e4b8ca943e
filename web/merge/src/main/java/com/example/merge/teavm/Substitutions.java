package com.example.merge.teavm;

import org.teavm.extension.spi.substitution.SimpleSubstitutionPolicy;
import org.teavm.extension.spi.substitution.SubstitutionSink;

/** Tells TeaVM which classes stand for others. TeaVM finds it as a service. */
public final class Substitutions extends SimpleSubstitutionPolicy {
    /** TeaVM makes it. */
    public Substitutions() {}

    @Override
    public void contribute(SubstitutionSink sink) {
        // gdx-teavm says so in META-INF/teavm.properties, which TeaVM 0.15 and later do not read.
        sink.selectClasses(inPackage("com.badlogic.gdx", true)).packagePrefix("emu");
        sink.substitutePackage("com.github.xpenatan.jmultiplatform.core", "com.example.merge.teavm");
    }
}
