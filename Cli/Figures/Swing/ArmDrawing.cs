using System.Text;
using Nowpose.Cli.Studies;
using Nowpose.Kinematics;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>Draws the real arm and, on top of it, the displayed arms without and with compensation.</summary>
/// <remarks>Draws each link as a capsule between frames from the headset's forward kinematics. Uses the page's colours.</remarks>
sealed class ArmDrawing(YoubotSwing swing)
{
    const int Width = 320;
    const int Height = 264;

    /// <summary>Dimensions in metres: the approximate thickness of the youBot's links, and the finger length of its URDF.</summary>
    const double LinkThickness = 0.055;
    const double FingerThickness = 0.014;
    const double FingerLength = 0.05;

    readonly Projection _view = new(425, 92, 62);
    readonly StringBuilder _svg = new();

    /// <param name="look">Line style of the compensated arm.</param>
    public string Draw(in StudyFrame frame, string look, double heldMm, double predictedMm)
    {
        _svg.Clear();
        Append($"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {Width} {Height}\">");
        Path();
        Arm(frame.Truth, "stroke:var(--truth);stroke-linecap:round", isSolid: true);
        Arm(frame.Held, "stroke:var(--hold);stroke-width:2;stroke-dasharray:5 3;stroke-linecap:butt", isSolid: false);
        Arm(frame.Predicted, $"stroke:var(--{look});stroke-width:2.5;stroke-linecap:round", isSolid: false);
        Gap(frame.Truth, frame.Held, "hold");
        Gap(frame.Truth, frame.Predicted, look);
        Caption(Height - 26, "hold", "stroke-dasharray:5 3;", $"uncompensated: {Numbers.Mm(heldMm)} off");
        Caption(Height - 8, look, "", $"compensated: {Numbers.Mm(predictedMm)} off");
        Append($"</svg>");
        return _svg.ToString();
    }

    // Draws the circular path of the tool for orientation.
    void Path()
    {
        var points = Enumerable.Range(0, 46).Select(i => Tool(YoubotSwing.FirstAngle + i * Math.PI / 90));
        Append($"<polyline points=\"{string.Join(' ', points.Select(p => FormattableString.Invariant($"{p.X:0.0},{p.Y:0.0}")))}\" ");
        Append($"style=\"fill:none;stroke:var(--muted);stroke-width:1;stroke-dasharray:1 4\"/>");
    }

    void Arm(double angle, string style, bool isSolid)
    {
        var links = swing.LinksAt(angle);
        Append($"<g style=\"fill:none;{style}\">");
        for (var i = 1; i < links.Length; i++)
        {
            var link = swing.Robot.Links[i];
            if (link.Name == swing.Robot.ToolLink.Name) continue;
            var isFinger = link.Name.Contains("finger", StringComparison.Ordinal);
            Line(_view.Of(links[link.ParentIndex]), _view.Of(links[i]), isSolid ? isFinger ? FingerThickness * 2 : LinkThickness : null);
            if (isFinger) Line(_view.Of(links[i]), _view.Of(TipOf(links[i])), isSolid ? FingerThickness : null);
        }
        Append($"</g>");
    }

    static RigidTransform TipOf(in RigidTransform finger) => finger * RigidTransform.FromXyzRpy(0, 0, FingerLength, 0, 0, 0);

    void Line((double X, double Y) from, (double X, double Y) to, double? thickness)
    {
        // Skips links whose frames are at the same point, for example the palm.
        if (Math.Abs(from.X - to.X) + Math.Abs(from.Y - to.Y) < 0.05) return;
        Append($"<line x1=\"{from.X:0.0}\" y1=\"{from.Y:0.0}\" x2=\"{to.X:0.0}\" y2=\"{to.Y:0.0}\"");
        if (thickness is double metres) Append($" style=\"stroke-width:{metres * _view.Scale:0.0}\"");
        Append($"/>");
    }

    void Gap(double truth, double shown, string look)
    {
        var (from, to) = (Tool(truth), Tool(shown));
        Append($"<line x1=\"{from.X:0.0}\" y1=\"{from.Y:0.0}\" x2=\"{to.X:0.0}\" y2=\"{to.Y:0.0}\" style=\"stroke:var(--ink);stroke-width:1\"/>");
        Append($"<circle cx=\"{to.X:0.0}\" cy=\"{to.Y:0.0}\" r=\"3.5\" style=\"fill:var(--{look});stroke:var(--surface);stroke-width:1\"/>");
        Append($"<circle cx=\"{from.X:0.0}\" cy=\"{from.Y:0.0}\" r=\"3.5\" style=\"fill:var(--surface);stroke:var(--ink);stroke-width:1.5\"/>");
    }

    void Caption(int y, string look, string dash, string text)
    {
        Append($"<line x1=\"10\" y1=\"{y - 4}\" x2=\"38\" y2=\"{y - 4}\" style=\"stroke:var(--{look});stroke-width:2.5;{dash}\"/>");
        Append($"<text x=\"46\" y=\"{y}\" style=\"fill:var(--ink);font:13px system-ui,sans-serif\">{text}</text>");
    }

    (double X, double Y) Tool(double angle) => _view.Of(swing.LinksAt(angle)[swing.Robot.IndexOfLink(swing.Robot.ToolLink.Name)]);

    void Append(FormattableString text) => _svg.Append(FormattableString.Invariant(text));
}
