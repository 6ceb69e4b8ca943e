/** The passes over joints, and what joints do to circles that sleep or rest. */
package io.github.circles2d.world.jvm.joints;
