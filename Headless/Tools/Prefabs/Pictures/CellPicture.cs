using Nowpose.Samples;

namespace Nowpose.Prefabs.Pictures;

/// <summary>Draws the README's picture: the whole cell while the arm carries a workpiece, without and with compensation.</summary>
static class CellPicture
{
    public const int Width = 480, Height = 280;

    /// <summary>Horizontal field of view of the camera, degrees.</summary>
    const double Field = 29;

    /// <summary>
    /// Minimum distance, perpendicular to the line of sight, by which the uncompensated gripper lags behind, m. Fast moves of the sample reach it.
    /// </summary>
    const float MinGapMetres = 0.06f;

    /// <summary>Position of the camera, and the point that it faces: above the base, between conveyor and fixture.</summary>
    static readonly Vector3 Camera = new(-0.75f, 0.8f, 1.2f), Middle = new(0, 0.09f, 0);

    /// <returns>Two drawings of the same frame, and the distance between the uncompensated and the displayed gripper, m.</returns>
    public static (string Uncompensated, string Compensated, double Gap) Draw(PlayedCell cell)
    {
        cell.Run(12);
        while (Vector3.Cross(Lag(cell), (Middle - Camera).normalized).magnitude < MinGapMetres || !Carried(cell).Any()) cell.Run(1 / 60.0);
        var camera = new PictureCamera(new Pose(Camera, Quaternion.LookRotation(Middle - Camera, Vector3.up)), Field, Width, Height);
        var stationary = cell.Objects<StationaryObject>().Select(shown => shown.gameObject).ToList();
        var displayed = cell.Objects<TrackedObject>().Where(shown => shown.Shows == RigPose.Displayed).ToList();
        var compensated = new SceneDrawing(camera).Draw(
            [cell.Real, .. stationary, .. displayed.Select(shown => shown.gameObject), GripperOf(cell.Displayed)]);
        MoveToHeldPoses(cell, displayed);
        var uncompensated = new SceneDrawing(camera).Draw(
            [cell.Real, .. stationary, .. displayed.Select(shown => shown.gameObject), GripperOf(cell.Displayed)]);
        return (uncompensated, compensated, Lag(cell).magnitude);
    }

    // Moves the virtual parts to the positions where a display without compensation shows them.
    static void MoveToHeldPoses(PlayedCell cell, IEnumerable<TrackedObject> displayed)
    {
        var held = cell.Objects<TrackedObject>().Where(shown => shown.Shows == RigPose.Held).ToDictionary(shown => shown.Frame);
        foreach (var shown in displayed)
        {
            var place = held[shown.Frame].transform;
            shown.transform.SetPositionAndRotation(place.position, place.rotation);
        }
        var (gripper, from, to) = (GripperOf(cell.Displayed).transform, cell.Displayed.Flange, GhostRig(cell).Flange);
        var turn = to.rotation * Quaternion.Inverse(from.rotation);
        gripper.SetPositionAndRotation(to.position + turn * (gripper.position - from.position), turn * gripper.rotation);
    }

    static IEnumerable<TrackedObject> Carried(PlayedCell cell) =>
        cell.Objects<TrackedObject>().Where(shown => shown.Parent != null && cell.Displayed.Link(shown.Parent) != null);

    static Vector3 Lag(PlayedCell cell) => cell.Displayed.Flange.position - GhostRig(cell).Flange.position;

    static RobotRig GhostRig(PlayedCell cell) => cell.Ghost.GetComponent<RobotRig>();

    static GameObject GripperOf(RobotRig rig) => rig.GetComponentInChildren<VirtualGripper>().gameObject;
}
