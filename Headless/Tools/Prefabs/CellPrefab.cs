namespace Nowpose.Prefabs;

/// <summary>Creates the prefab with the objects of one robot: session, base anchor, rig with gripper, ghost and panel.</summary>
sealed class CellPrefab
{
    readonly PackageAssets _assets;
    readonly RobotDescriptionAsset _robot;
    readonly MrilSession _session;

    CellPrefab(PackageAssets assets, string name, RobotDescriptionAsset robot)
    {
        _assets = assets;
        _robot = robot;
        _session = new GameObject(name).AddComponent<MrilSession>();
    }

    /// <param name="path">Path of the prefab. The name of the prefab is the file name.</param>
    /// <param name="robotPath">Path of the robot's description; null to use the robot that the gateway describes.</param>
    public static string Make(PackageAssets assets, string path, string robotPath)
    {
        var robot = robotPath == null ? null : assets.Load<RobotDescriptionAsset>(robotPath);
        return new CellPrefab(assets, Path.GetFileNameWithoutExtension(path), robot).Make();
    }

    string Make()
    {
        Fields.Set(_session, "_settings", _assets.Load<SessionSettingsAsset>(PackagePaths.Settings));
        Fields.Set(_session, "_robot", _robot);
        Fields.Set(_session.gameObject.AddComponent<RenderTimeSource>(), "_session", _session);
        var loader = _session.gameObject.AddComponent<LatencyProfileLoader>();
        Fields.Set(loader, "_session", _session);

        var anchor = Children.Add("Base Anchor", _session.transform);
        anchor.AddComponent<BaseAnchor>();
        var displayed = new RobotObjects(_assets, _robot, _session).AddTo(anchor.transform);
        AddNudge(displayed, loader);
        AddPanel();
        return _assets.Prefab(_session.gameObject);
    }

    /// <summary>Adds the component for calibration by eye, disabled by default.</summary>
    void AddNudge(RobotRig displayed, LatencyProfileLoader loader)
    {
        var nudge = _session.gameObject.AddComponent<LatencyNudge>();
        Fields.Set(nudge, "_session", _session);
        Fields.Set(nudge, "_rig", displayed);
        Fields.Set(nudge, "_loader", loader);
        nudge.enabled = false;
    }

    void AddPanel()
    {
        var panel = Children.Add("Status Panel", _session.transform);
        panel.AddComponent<BodyFollow>();
        var cell = Texts.Add(_assets, "Cell", panel.transform, TextAnchor.UpperLeft, TextAlignment.Left);
        cell.gameObject.SetActive(false);
        var status = panel.AddComponent<StatusPanel>();
        Fields.Set(status, "_session", _session);
        Fields.Set(status, "_cell", cell);
        Fields.Set(status, "_ground", _assets.Load<Material>(PackagePaths.Backdrop));
    }
}
