using System.Globalization;
using System.Text.RegularExpressions;
using MixedReality.Toolkit.UX;
using Nowpose.Prefabs.Mrtk3;
using Nowpose.Unity.Status;

namespace Nowpose.Prefabs.Pictures;

/// <summary>Draws the manual's pictures, which show the package's prefabs as a user sees them.</summary>
static class ManualPictures
{
    /// <summary>Matches a coordinate of a path, such as M201.8 168.9L101.6 162.7Z.</summary>
    static readonly Regex Coordinate = new(@"(?<=[ML])-?\d+\.\d(?= )|(?<= )-?\d+\.\d(?=[LZ])");

    const string Folder = "Packages/com.nowpose.mril/Documentation~/images/";

    /// <summary>Field of view of a HoloLens 2, degrees.</summary>
    const double FieldWidth = 43, FieldHeight = 29;

    const int PanelWidth = 900, PartWidth = 320, PartHeight = 320, Caption = 28;

    /// <summary>Distance between the displayed gripper and the ghost in the picture, so that both are visible.</summary>
    const float GapMetres = 0.05f;

    /// <summary>Draws the pictures whose files differ from what is drawn.</summary>
    /// <returns>Paths relative to the root, and what is drawn.</returns>
    public static IEnumerable<(string Path, string Svg)> Differing(string root) =>
        new[] { ("pose-appearance.svg", Appearance(root)), ("status-panel.svg", Panel(root)), ("cell.svg", Cell(root)) }
            .Select(picture => (Path: Folder + picture.Item1, Svg: picture.Item2))
            .Where(picture => !File.Exists(Path.Combine(root, picture.Path)) || Differ(File.ReadAllText(Path.Combine(root, picture.Path)), picture.Svg));

    // Another processor may round a coordinate in the other direction.
    static bool Differ(string file, string drawn)
    {
        static IEnumerable<double> Coordinates(string svg) => Coordinate.Matches(svg).Select(match => double.Parse(match.Value, CultureInfo.InvariantCulture));
        return Coordinate.Replace(file, "") != Coordinate.Replace(drawn, "")
            || Coordinates(file).Zip(Coordinates(drawn), (one, other) => Math.Abs(one - other)).Any(difference => difference > 0.15);
    }

    /// <summary>Draws the whole cell without and with compensation, at the same moment.</summary>
    public static string Cell(string root)
    {
        using var cell = new PlayedCell(root);
        var (uncompensated, compensated, gap) = CellPicture.Draw(cell);
        return Parts(
            "A simulated cell while the arm carries a workpiece: without compensation, the virtual gripper and the workpieces lag behind the real arm",
            CellPicture.Width, CellPicture.Height,
            (string.Create(CultureInfo.InvariantCulture, $"without Nowpose: {1000 * gap:0} mm behind"), uncompensated), ("with Nowpose", compensated));
    }

    /// <summary>Draws the gripper at the end of the arm three times: current, current next to the ghost, and held.</summary>
    public static string Appearance(string root)
    {
        using var cell = new PlayedCell(root);
        cell.Run(12);
        while (Vector3.Distance(cell.Displayed.Tool.position, cell.Ghost.GetComponent<RobotRig>().Tool.position) < GapMetres) cell.Run(1 / 60.0);
        LookAtTheGripper(cell);
        var current = new SceneDrawing(Before(cell)).Draw([cell.Real, cell.Displayed.gameObject]);
        var compared = new SceneDrawing(Before(cell, leftShare: -0.5f)).Draw([cell.Real, cell.Ghost, cell.Displayed.gameObject]);
        cell.CutOff();
        cell.Run(2);
        var camera = LookAtTheGripper(cell);
        var held = new SceneDrawing(camera).Draw([cell.Real, cell.Displayed.gameObject]);
        return Parts(
            "The virtual gripper at the arm's end: current; current beside the ghost; held, with stripes and words", PartWidth, PartHeight,
            ("current", current), ("current, and the ghost", compared), ("held: no sample for 2 s", held));
    }

    // The text faces the head, and its size depends on the distance to the head.
    static PictureCamera LookAtTheGripper(PlayedCell cell)
    {
        var camera = Before(cell);
        cell.Head.SetPositionAndRotation(camera.Place.position, camera.Place.rotation);
        cell.Run(0.1);
        return camera;
    }

    /// <summary>
    /// Returns a camera in front of the gripper. From there, no part of the arm hides the gripper. The text is on the left, and that of the ghost on
    /// the right.
    /// </summary>
    /// <param name="leftShare">Distance of the middle of the picture to the left of the gripper, as a share of that of the text.</param>
    static PictureCamera Before(PlayedCell cell, float leftShare = 1f / 3)
    {
        var gripper = cell.Displayed.GetComponentInChildren<VirtualGripper>().transform;
        var left = GripperPrefab.WordsOf(gripper.gameObject).transform.position - gripper.position;
        left.y = 0;
        var ahead = Vector3.Cross(Vector3.up, left.normalized);
        var middle = (gripper.position + cell.Displayed.Tool.position) / 2 + left * leftShare;
        var place = middle - 0.6f * ahead + 0.15f * Vector3.up;
        return new PictureCamera(new Pose(place, Quaternion.LookRotation(middle - place, Vector3.up)), 24, PartWidth, PartHeight);
    }

    /// <summary>Draws the view of a HoloLens 2 with a level head: the panel without and with a message.</summary>
    public static string Panel(string root)
    {
        using var cell = new PlayedCell(root);
        cell.Head.SetPositionAndRotation(new Vector3(0, 1.6f, -2), Quaternion.identity);
        cell.Run(12);
        var height = (int)Math.Round(PanelWidth * Math.Tan(FieldHeight / 2 * Math.PI / 180) / Math.Tan(FieldWidth / 2 * Math.PI / 180));
        var camera = new PictureCamera(new Pose(cell.Head.position, cell.Head.rotation), FieldWidth, PanelWidth, height);
        var texts = new StatusTexts();
        texts.Update(cell.Session.Statistics, cell.Session.Settings, cell.Session.Robot.Name,
            "joint positions: no connection to 192.168.0.20:47011 (connection refused); start the gateway there, or correct Host in the session "
            + "settings; trying again in 4 s");
        cell.Panel.Cells.Show(texts);
        var drawing = new SceneDrawing(camera).Draw([cell.Panel.gameObject]) + Buttons(cell.Panel, camera);
        return Svg(PanelWidth, height,
            $"""<line x1="0" x2="{PanelWidth}" y1="{height / 2}" y2="{height / 2}" stroke="#55616f" stroke-dasharray="2 6"/>""" + "\n"
            + $"""<text x="8" y="{height / 2 - 6}" font-size="13" fill="#8b98a7">level</text>""" + "\n" + drawing,
            "The status panel with a message on top, in a HoloLens 2's field of view of 43 by 29 degrees");
    }

    /// <summary>Draws the outlines of MRTK3's buttons, whose meshes are not available here.</summary>
    static string Buttons(StatusPanel panel, PictureCamera camera) => string.Concat(panel.GetComponentsInChildren<PressableButton>().Select(button =>
    {
        var rect = (RectTransform)button.transform;
        var corners = new[] { (-1, -1), (1, -1), (1, 1), (-1, 1) }.Select(c => camera.Project(rect.parent.TransformPoint(
            new Vector3(rect._anchoredPosition.x + c.Item1 * rect._sizeDelta.x / 2, rect._anchoredPosition.y + c.Item2 * rect._sizeDelta.y / 2, 0))));
        var points = string.Join(" ", corners.Select(c => string.Create(CultureInfo.InvariantCulture, $"{c.X:0.0},{c.Y:0.0}")));
        return $"""<polygon points="{points}" fill="#2a3a52" stroke="#8b98a7"/>""" + "\n";
    }));

    static string Parts(string label, int width, int height, params (string Words, string Drawing)[] parts) => Svg(
        parts.Length * width, height + Caption, string.Concat(parts.Select((part, i) =>
        $"""<svg x="{i * width}" y="0" width="{width - 4}" height="{height}" viewBox="0 0 {width} {height}">""" + "\n"
        + part.Drawing + "</svg>\n"
        + $"""<text x="{(i + 0.5) * width}" y="{height + 20}" font-size="15" text-anchor="middle">{part.Words}</text>""" + "\n")), label);

    static string Svg(int width, int height, string content, string label) =>
        $"""<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" role="img" aria-label="{label}" """
        + """font-family="Liberation Sans, Arial, Helvetica, sans-serif" fill="#f2f6fa">""" + "\n"
        + $"""<rect width="{width}" height="{height}" fill="#1b222b"/>""" + "\n" + content + "</svg>\n";
}
