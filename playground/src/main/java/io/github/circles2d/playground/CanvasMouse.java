package io.github.circles2d.playground;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.swing.SwingUtilities;

/** The left button uses the tool, the others move the picture, the wheel zooms; with shift it sizes the brush. */
final class CanvasMouse extends MouseAdapter {
    private static final double NOTCH = 1.15;

    private final PlaygroundCanvas canvas;
    private final SessionLoop loop;
    private boolean panning;
    private int lastX;
    private int lastY;

    private CanvasMouse(PlaygroundCanvas canvas, SessionLoop loop) {
        this.canvas = canvas;
        this.loop = loop;
    }

    static void listen(PlaygroundCanvas canvas, SessionLoop loop) {
        CanvasMouse mouse = new CanvasMouse(canvas, loop);
        canvas.addMouseListener(mouse);
        canvas.addMouseMotionListener(mouse);
        canvas.addMouseWheelListener(mouse);
    }

    @Override
    public void mousePressed(MouseEvent event) {
        canvas.requestFocusInWindow();
        canvas.hideHelp();
        lastX = event.getX();
        lastY = event.getY();
        if (SwingUtilities.isLeftMouseButton(event)) {
            float x = canvas.worldX(event.getX());
            float y = canvas.worldY(event.getY());
            loop.ask(session -> session.press(x, y));
        } else {
            panning = true;
        }
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        if (SwingUtilities.isLeftMouseButton(event)) {
            loop.ask(Session::release);
        } else {
            panning = false;
        }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (panning) {
            canvas.pan(event.getX() - lastX, event.getY() - lastY);
        }
        lastX = event.getX();
        lastY = event.getY();
        mouseMoved(event);
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        canvas.setMouse(event.getPoint());
        float x = canvas.worldX(event.getX());
        float y = canvas.worldY(event.getY());
        loop.ask(session -> session.moveMouse(x, y));
    }

    @Override
    public void mouseExited(MouseEvent event) {
        canvas.setMouse(null);
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        if (canvas.scrollHelp(event.getPreciseWheelRotation())) {
            return;
        }
        if (event.isShiftDown()) {
            int notches = event.getPreciseWheelRotation() < 0 ? 1 : -1;
            loop.ask(session -> session.scaleBrush(notches));
        } else {
            canvas.zoom(Math.pow(NOTCH, -event.getPreciseWheelRotation()), event.getX(), event.getY());
        }
    }
}
