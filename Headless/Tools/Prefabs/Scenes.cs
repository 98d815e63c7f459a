using Nowpose.Samples;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Prefabs;

/// <summary>Creates scenes for a desktop without a real arm.</summary>
static class Scenes
{
    /// <summary>Creates the scene of the Unity project in this repository.</summary>
    public static string Demo(PackageAssets assets)
    {
        var cell = Cell(assets, PackagePaths.Cell, PackagePaths.Settings);
        Draw(assets, cell);
        return Save(assets, cell);
    }

    public static string Connect(PackageAssets assets, string cellPath)
    {
        var cell = Cell(assets, cellPath, PackagePaths.ConnectSettings);
        Draw(assets, cell);
        return Save(assets, cell);
    }

    /// <summary>Creates a scene that also draws the real arm, at its simulated position. The arm hides the virtual parts behind it.</summary>
    public static string VirtualRobotCell(PackageAssets assets)
    {
        var cell = Cell(assets, PackagePaths.Cell, PackagePaths.VirtualSettings);
        foreach (var part in Arm(assets, cell)) part.enabled = false;
        cell.GetComponentInChildren<Ghost>(includeInactive: true).gameObject.SetActive(true);
        var session = cell.GetComponent<MrilSession>();
        Fields.Set(session, "_connectOnEnable", false);

        var robot = assets.Load<RobotDescriptionAsset>(PackagePaths.Youbot);
        var control = new GameObject("Simulated Control System").AddComponent<SimulatedControlSystem>();
        Fields.Set(control, "_session", session);
        Fields.Set(control, "_robot", robot);
        var solid = assets.Load<Material>(PackagePaths.Solid);
        var real = Rigs.Build(robot, null, solid, solid);
        real.name = "Real Robot";
        Fields.Set(real.gameObject.AddComponent<TruthRig>(), "_controlSystem", control);
        TransformRounding.Apply(real.transform);
        var objects = WorkObjects.Build(assets, session, robot.Read());
        return Save(assets, control.gameObject, real.gameObject, cell, objects);
    }

    /// <summary>Creates a scene for a headset. In the editor without a headset, the camera stays at the origin and sees all objects.</summary>
    public static string DisplayCalibration(PackageAssets assets)
    {
        var cell = Cell(assets, PackagePaths.Cell, PackagePaths.CalibrationSettings);
        cell.transform.Find("Base Anchor").localPosition = AnyHeadsetScene.BasePlace;
        // Places the panel so that its lower edge is in view and its upper edge is below the code.
        Fields.Set(cell.GetComponentInChildren<StatusPanel>(includeInactive: true).GetComponent<BodyFollow>(), "_degreesBelow", 8f);
        CalibrationObjects.Add(assets, cell.GetComponent<MrilSession>());
        var rig = new GameObject("Tracking Origin");
        var camera = Props.HeadsetCamera();
        camera.transform.SetParent(rig.transform, worldPositionStays: false);
        camera.AddComponent<TrackedCamera>();
        return assets.Scene(rig, Props.Light(hasShadows: false), cell);
    }

    /// <param name="settingsPath">Path of the scene's own settings, because those of an installed package are read-only.</param>
    internal static GameObject Cell(PackageAssets assets, string cellPath, string settingsPath)
    {
        var cell = assets.Instantiate(cellPath, null);
        Fields.Set(cell.GetComponent<MrilSession>(), "_settings", assets.Load<SessionSettingsAsset>(settingsPath));
        return cell;
    }

    /// <summary>Returns the invisible renderers of the arm, which hide the gripper where it is behind the real arm.</summary>
    static IEnumerable<MeshRenderer> Arm(PackageAssets assets, GameObject cell)
    {
        var occluder = assets.Load<Material>(PackagePaths.Occluder);
        return cell.transform.Find("Base Anchor/Robot").GetComponentsInChildren<MeshRenderer>(includeInactive: true)
            .Where(r => r.sharedMaterial == occluder);
    }

    /// <summary>Makes the arm visible, even if it is built at run time.</summary>
    static void Draw(PackageAssets assets, GameObject cell)
    {
        var material = assets.Load<Material>(PackagePaths.Arm);
        foreach (var part in Arm(assets, cell)) part.sharedMaterial = material;
        Fields.Set(cell.transform.Find("Base Anchor/Robot").GetComponent<RobotRig>(), "_armMaterial", material);
    }

    static string Save(PackageAssets assets, params GameObject[] robots)
    {
        var props = new[] { Props.Camera(new Vector3(0, 0.75f, -1.25f), new Vector3(20, 0, 0)), Props.Light(), Props.Ground(assets) };
        return assets.Scene(props.Concat(robots).ToArray());
    }
}
