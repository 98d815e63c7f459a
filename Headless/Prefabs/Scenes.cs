using UnityEngine;

namespace Nowpose.Prefabs;

static class Scenes
{
    /// <summary>The host project's scene, for a desktop: no real arm is there to be seen, so the rig's own is drawn.</summary>
    public static string Demo(Workshop workshop)
    {
        var ground = Props.Ground();
        var cell = workshop.Instantiate(PackagePaths.Cell, null);
        var arm = cell.transform.Find("Base Anchor/Robot");
        var occluder = workshop.Load<Material>(PackagePaths.Occluder);
        foreach (var renderer in arm.GetComponentsInChildren<MeshRenderer>(includeInactive: true))
        {
            if (renderer.sharedMaterial == occluder) renderer.sharedMaterial = ground.GetComponent<MeshRenderer>().sharedMaterial;
        }
        return workshop.Scene(Props.Camera(new Vector3(0, 0.75f, -1.25f), new Vector3(20, 0, 0)), Props.Light(), ground, cell);
    }
}
