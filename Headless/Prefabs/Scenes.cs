using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Prefabs;

/// <summary>Scenes for a desktop: no real arm is there to be seen and to hide what is behind it, so the rig's own is drawn.</summary>
static class Scenes
{
    /// <summary>Of the host project.</summary>
    public static string Demo(Workshop workshop) => Save(workshop, VisibleCell(workshop));

    /// <summary>With settings of its own, which can be changed where those of an installed package cannot.</summary>
    public static string Connect(Workshop workshop)
    {
        var cell = VisibleCell(workshop);
        Fields.Set(cell.GetComponent<MrilSession>(), "_settings", workshop.Load<SessionSettingsAsset>(PackagePaths.ConnectSettings));
        return Save(workshop, cell);
    }

    static GameObject VisibleCell(Workshop workshop)
    {
        var cell = workshop.Instantiate(PackagePaths.Cell, null);
        var occluder = workshop.Load<Material>(PackagePaths.Occluder);
        foreach (var renderer in cell.transform.Find("Base Anchor/Robot").GetComponentsInChildren<MeshRenderer>(includeInactive: true))
        {
            if (renderer.sharedMaterial == occluder) renderer.sharedMaterial = Props.DefaultMaterial;
        }
        return cell;
    }

    static string Save(Workshop workshop, params GameObject[] robots)
    {
        var props = new[] { Props.Camera(new Vector3(0, 0.75f, -1.25f), new Vector3(20, 0, 0)), Props.Light(), Props.Ground() };
        return workshop.Scene(props.Concat(robots).ToArray());
    }
}
