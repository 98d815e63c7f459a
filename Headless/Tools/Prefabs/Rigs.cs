using Object = UnityEngine.Object;

namespace Nowpose.Prefabs;

/// <summary>Builds rigs in the same way as the component at run time, to store them in a prefab.</summary>
static class Rigs
{
    /// <param name="robot">Description of the robot; null to create a rig that builds itself when its robot is known.</param>
    /// <param name="parent">Parent of the rig; null to create the rig without a parent.</param>
    /// <param name="arm">Material of the links up to the flange.</param>
    /// <param name="tool">Material of the links beyond the flange.</param>
    public static RobotRig Build(RobotDescriptionAsset robot, Transform parent, Material arm, Material tool)
    {
        var rig = new GameObject("Robot").AddComponent<RobotRig>();
        if (parent != null) rig.transform.SetParent(parent, worldPositionStays: false);
        Fields.Set(rig, "_armMaterial", arm);
        Fields.Set(rig, "_toolMaterial", tool);
        if (robot != null) rig.Bind(robot.Read());
        return rig;
    }

    /// <summary>Removes the renderers below a link, because the virtual gripper has its own.</summary>
    public static void HideBelow(Transform link)
    {
        foreach (var renderer in link.GetComponentsInChildren<MeshRenderer>(includeInactive: true))
        {
            if (renderer.transform.parent != link) Object.DestroyImmediate(renderer.gameObject);
        }
    }
}
