namespace Nowpose.Prefabs;

/// <summary>Adds the actions of a cell to the package's cell prefab in a scene.</summary>
static class CellObjects
{
    /// <summary>Adds the component that provides the actions of the cell, for example for buttons and menus.</summary>
    public static CellActions AddActions(PackageAssets assets, MrilSession session)
    {
        var actions = session.gameObject.AddComponent<CellActions>();
        Assign(assets, actions, session, session.GetComponentInChildren<StatusPanel>(includeInactive: true));
        return actions;
    }

    public static void Assign(PackageAssets assets, CellActions actions, MrilSession session, StatusPanel panel)
    {
        var displayed = session.transform.Find("Base Anchor/Robot");
        Fields.Set(actions, "_session", session);
        Fields.Set(actions, "_anchor", session.GetComponentInChildren<BaseAnchor>(includeInactive: true));
        Fields.Set(actions, "_ghost", session.GetComponentInChildren<Ghost>(includeInactive: true));
        Fields.Set(actions, "_appearance", displayed.GetComponent<PoseAppearance>());
        Fields.Set(actions, "_panel", panel);
        Fields.Set(actions, "_pairing", session.GetComponentInChildren<CellPairing>(includeInactive: true));
        Fields.Set(actions, "_occluder", assets.Load<Material>(PackagePaths.Occluder));
    }
}
