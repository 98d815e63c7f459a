using Nowpose.Unity;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Prefabs;

/// <summary>Builds rigs like the component does at run time, to be stored in a prefab.</summary>
static class Rigs
{
    /// <param name="robot">Null for a rig that builds itself once its robot is known.</param>
    /// <param name="parent">Null for none.</param>
    /// <param name="arm">Material of the links up to the flange.</param>
    /// <param name="tool">Material of the links that the flange carries.</param>
    public static RobotRig Build(RobotDescriptionAsset robot, Transform parent, Material arm, Material tool)
    {
        var rig = new GameObject("Robot").AddComponent<RobotRig>();
        if (parent != null) rig.transform.SetParent(parent, worldPositionStays: false);
        Fields.Set(rig, "_armMaterial", arm);
        Fields.Set(rig, "_toolMaterial", tool);
        if (robot != null) rig.Bind(robot.Read());
        return rig;
    }

    /// <summary>Removes the renderers of the links below a link, because the virtual gripper has its own.</summary>
    public static void HideBelow(Transform link)
    {
        foreach (var renderer in link.GetComponentsInChildren<MeshRenderer>(includeInactive: true))
        {
            if (renderer.transform.parent != link) Object.DestroyImmediate(renderer.gameObject);
        }
    }
}
