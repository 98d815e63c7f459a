using Nowpose.Samples;

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
    internal static IEnumerable<MeshRenderer> Arm(PackageAssets assets, RobotRig displayed)
    {
        var occluder = assets.Load<Material>(PackagePaths.Occluder);
        return displayed.GetComponentsInChildren<MeshRenderer>(includeInactive: true)
            .Where(r => r.sharedMaterial == occluder);
    }

    /// <summary>Returns the displayed rig of an instance of the cell prefab.</summary>
    internal static RobotRig DisplayedIn(GameObject cell) => cell.transform.Find("Base Anchor/Robot").GetComponent<RobotRig>();

    /// <summary>Makes the arm visible, even if it is built at run time.</summary>
    static void Draw(PackageAssets assets, GameObject cell)
    {
        var material = assets.Load<Material>(PackagePaths.Arm);
        var displayed = DisplayedIn(cell);
        foreach (var part in Arm(assets, displayed)) part.sharedMaterial = material;
        Fields.Set(displayed, "_armMaterial", material);
    }

    static string Save(PackageAssets assets, params GameObject[] robots) => Desktop(assets, InFront(), robots);

    /// <summary>Creates a camera in front of a robot at the origin.</summary>
    internal static GameObject InFront() => Props.Camera(new Vector3(0, 0.75f, -1.25f), new Vector3(20, 0, 0));

    internal static string Desktop(PackageAssets assets, GameObject camera, params GameObject[] robots) =>
        assets.Scene(new[] { camera, Props.Light(), Props.Ground(assets) }.Concat(robots).ToArray());
}
