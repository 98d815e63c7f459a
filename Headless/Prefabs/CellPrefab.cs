using Nowpose.Unity;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Prefabs;

/// <summary>Everything that a scene needs of one robot: its session, where it stands, its rig with the gripper, the ghost, the panel.</summary>
static class CellPrefab
{
    /// <param name="path">Of the prefab, which bears the file's name.</param>
    /// <param name="robotPath">Of the robot's description; null for the one that the gateway describes.</param>
    public static string Make(Workshop workshop, string path, string robotPath)
    {
        var cell = new GameObject(Path.GetFileNameWithoutExtension(path));
        var robot = robotPath == null ? null : workshop.Load<RobotDescriptionAsset>(robotPath);
        var session = cell.AddComponent<MrilSession>();
        Fields.Set(session, "_settings", workshop.Load<SessionSettingsAsset>(PackagePaths.Settings));
        Fields.Set(session, "_robot", robot);
        Fields.Set(cell.AddComponent<RenderTimeSource>(), "_session", session);

        var anchor = new GameObject("Base Anchor");
        anchor.transform.SetParent(cell.transform, worldPositionStays: false);
        anchor.AddComponent<BaseAnchor>();

        var occluder = workshop.Load<Material>(PackagePaths.Occluder);
        var displayed = Rig(workshop, session, robot, anchor.transform, occluder, workshop.Load<Material>(PackagePaths.Hologram));
        AddGripper(workshop, displayed);
        AddGhost(workshop, session, robot, displayed);
        AddPanel(session, workshop.Load<Material>(PackagePaths.Panel));
        return workshop.Prefab(cell);
    }

    static RobotRig Rig(Workshop workshop, MrilSession session, RobotDescriptionAsset robot, Transform anchor, Material arm, Material tool)
    {
        var rig = Rigs.Build(robot, anchor, arm, tool);
        Fields.Set(rig, "_session", session);
        return rig;
    }

    // Beside a robot that is not built yet: it then follows its flange.
    static GameObject AddGripper(Workshop workshop, RobotRig rig)
    {
        if (rig.Flange != null) Rigs.HideBelow(rig.Flange);
        return workshop.Instantiate(PackagePaths.Gripper, rig.Flange != null ? rig.Flange : rig.transform);
    }

    static void AddPanel(MrilSession session, Material ground)
    {
        var panel = new GameObject("Status Panel");
        panel.transform.SetParent(session.transform, worldPositionStays: false);
        panel.AddComponent<BodyFollow>();
        var cell = Texts.Add("Cell", panel.transform, TextAnchor.UpperLeft, TextAlignment.Left);
        cell.gameObject.SetActive(false);
        var status = panel.AddComponent<StatusPanel>();
        Fields.Set(status, "_session", session);
        Fields.Set(status, "_cell", cell);
        Fields.Set(status, "_ground", ground);
    }

    /// <summary>Hidden until somebody wants to compare.</summary>
    static void AddGhost(Workshop workshop, MrilSession session, RobotDescriptionAsset robot, RobotRig displayed)
    {
        var look = workshop.Load<Material>(PackagePaths.Ghost);
        var rig = Rig(workshop, session, robot, displayed.transform.parent, look, look);
        rig.name = "Ghost";
        Fields.Set(rig, "_shows", RigPose.Held);
        Fields.Set(rig.gameObject.AddComponent<Ghost>(), "_displayed", displayed);
        var gripper = AddGripper(workshop, rig);
        foreach (var part in gripper.GetComponentsInChildren<MeshFilter>(includeInactive: true))
            part.GetComponent<MeshRenderer>().sharedMaterial = look;

        // One for arm and gripper, and without words: the other gripper has them.
        Object.DestroyImmediate(gripper.GetComponent<PoseAppearance>());
        gripper.transform.Find(GripperPrefab.Words).gameObject.SetActive(false);
        Fields.Set(rig.gameObject.AddComponent<PoseAppearance>(), "_session", session);
        rig.gameObject.SetActive(false);
    }
}
