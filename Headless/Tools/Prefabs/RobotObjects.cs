using Object = UnityEngine.Object;

namespace Nowpose.Prefabs;

/// <summary>Creates the objects of one robot: the displayed rig with a gripper, and its ghost.</summary>
sealed class RobotObjects
{
    readonly PackageAssets _assets;
    readonly RobotDescriptionAsset _robot;
    readonly MrilSession _session;

    /// <param name="robot">Description of the robot; null to use the robot that the gateway describes.</param>
    /// <param name="session">The session that moves the robot; null to use the session above the objects.</param>
    public RobotObjects(PackageAssets assets, RobotDescriptionAsset robot, MrilSession session)
    {
        _assets = assets;
        _robot = robot;
        _session = session;
    }

    /// <summary>Creates the prefab of another robot in a cell, whose user selects the namespace.</summary>
    public static string MakePrefab(PackageAssets assets, string path, string robotPath)
    {
        var robot = assets.Load<RobotDescriptionAsset>(robotPath);
        var root = new GameObject(Path.GetFileNameWithoutExtension(path));
        new RobotObjects(assets, robot, null).AddTo(root.transform);
        foreach (var rig in root.GetComponentsInChildren<RobotRig>(includeInactive: true)) Fields.Set(rig, "_description", robot);
        return assets.Prefab(root);
    }

    /// <returns>The displayed rig.</returns>
    public RobotRig AddTo(Transform parent)
    {
        var displayed = AddDisplayed(parent);
        AddGhost(parent, displayed);
        return displayed;
    }

    RobotRig AddDisplayed(Transform parent)
    {
        var occluder = _assets.Load<Material>(PackagePaths.Occluder);
        var rig = Rig(parent, occluder, _assets.Load<Material>(PackagePaths.Hologram), out var gripper);
        Fields.Set(rig.GetComponent<PoseAppearance>(), "_words", GripperPrefab.WordsOf(gripper));
        return rig;
    }

    /// <summary>Adds the ghost, hidden until the user enables it. Its label and that of the robot are at different sides of the tool.</summary>
    void AddGhost(Transform parent, RobotRig displayed)
    {
        var look = _assets.Load<Material>(PackagePaths.Ghost);
        var rig = Rig(parent, look, look, out var gripper);
        rig.name = "Ghost";
        Fields.Set(rig, "_shows", RigPose.Held);
        Fields.Set(rig.gameObject.AddComponent<Ghost>(), "_displayed", displayed);
        foreach (var part in gripper.GetComponentsInChildren<MeshFilter>(includeInactive: true))
            part.GetComponent<MeshRenderer>().sharedMaterial = look;
        var words = GripperPrefab.WordsOf(gripper);
        words.anchor = TextAnchor.UpperCenter;
        words.transform.localPosition = Vector3.Scale(words.transform.localPosition, new Vector3(-1, 1, 1));
        Fields.Set(rig.GetComponent<PoseAppearance>(), "_words", words);
        rig.gameObject.SetActive(false);
    }

    /// <summary>Creates the rig. The parent of the gripper is the flange or, if the robot is not known yet, the rig.</summary>
    RobotRig Rig(Transform parent, Material arm, Material tool, out GameObject gripper)
    {
        var rig = Rigs.Build(_robot, parent, arm, tool);
        Fields.Set(rig, "_session", _session);
        if (rig.Flange != null) Rigs.HideBelow(rig.Flange);
        gripper = _assets.Instantiate(PackagePaths.Gripper, rig.Flange != null ? rig.Flange : rig.transform);

        // Replaces the appearance of the gripper with one for the complete rig, including parts that are built at run time.
        Object.DestroyImmediate(gripper.GetComponent<PoseAppearance>());
        var appearance = rig.gameObject.AddComponent<PoseAppearance>();
        Fields.Set(appearance, "_session", _session);
        Fields.Set(appearance, "_substitute", tool);
        return rig;
    }
}
