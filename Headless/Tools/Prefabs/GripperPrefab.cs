using Nowpose.Unity;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Prefabs;

/// <summary>The youBot's gripper by itself, in the flange's frame, its fingers closed.</summary>
static class GripperPrefab
{
    const string Words = "Words";

    /// <summary>Where an instance of it says why a pose is not current.</summary>
    public static TextMesh WordsOf(GameObject gripper) => gripper.transform.Find(Words).GetComponent<TextMesh>();

    public static string Make(Workshop workshop)
    {
        var hologram = workshop.Load<Material>(PackagePaths.Hologram);
        var robot = Rigs.Build(workshop.Load<RobotDescriptionAsset>(PackagePaths.Youbot), null, hologram, hologram);

        // The names differ from the links', or a rig that the gripper rides on would take them for its own.
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
        AddAppearance(workshop, gripper, hologram);
        return workshop.Prefab(gripper);
    }

    /// <summary>Part of the gripper, so that nobody who mounts it by itself takes an old pose for a current one.</summary>
    static void AddAppearance(Workshop workshop, GameObject gripper, Material substitute)
    {
        var words = Texts.Add(workshop, Words, gripper.transform, TextAnchor.MiddleCenter, TextAlignment.Center);
        // Beside the palm: they cover neither the fingers nor what these grasp.
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
