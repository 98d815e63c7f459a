using Object = UnityEngine.Object;

namespace Nowpose.Prefabs;

/// <summary>Creates the youBot's gripper as a separate prefab, in the frame of the flange and with closed fingers.</summary>
static class GripperPrefab
{
    const string Words = "Words";

    /// <summary>Returns the text object of a gripper instance, which states why the gripper's pose is not current.</summary>
    public static TextMesh WordsOf(GameObject gripper) => gripper.transform.Find(Words).GetComponent<TextMesh>();

    public static string Make(PackageAssets assets)
    {
        var hologram = assets.Load<Material>(PackagePaths.Hologram);
        var robot = Rigs.Build(assets.Load<RobotDescriptionAsset>(PackagePaths.Youbot), null, hologram, hologram);

        // The names must differ from the names of the links. Otherwise, a rig would use these objects as its own links.
        var palm = Named(robot.Link("gripper_palm_link"), "Palm");
        var left = Named(robot.Link("gripper_finger_link_l"), "Left Finger");
        var right = Named(robot.Link("gripper_finger_link_r"), "Right Finger");
        Object.DestroyImmediate(robot.Link("tool_centre_point").gameObject);

        var gripper = new GameObject("Virtual Gripper");
        palm.SetParent(gripper.transform, worldPositionStays: false);
        Fields.Set(gripper.AddComponent<VirtualGripper>(), "_fingers", new List<GripperFinger>
        {
            new("gripper_finger_joint_l", left),
            new("gripper_finger_joint_r", right),
        });
        AddAppearance(assets, gripper, hologram);
        return assets.Prefab(gripper);
    }

    /// <summary>Adds the appearance to the gripper itself. A gripper without a rig therefore also shows that its pose is outdated.</summary>
    static void AddAppearance(PackageAssets assets, GameObject gripper, Material substitute)
    {
        // Above its position, because the label of the ghost is below.
        var words = Texts.Add(assets, Words, gripper.transform, TextAnchor.LowerCenter, TextAlignment.Center);
        // Places the text next to the palm, where it hides neither the fingers nor a grasped object.
        words.transform.localPosition = new Vector3(0.12f, 0.02f, 0);
        var appearance = gripper.AddComponent<PoseAppearance>();
        Fields.Set(appearance, "_words", words);
        Fields.Set(appearance, "_substitute", substitute);
    }

    static Transform Named(Transform link, string name)
    {
        link.name = name;
        return link;
    }
}
