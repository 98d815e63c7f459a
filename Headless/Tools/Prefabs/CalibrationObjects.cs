namespace Nowpose.Prefabs;

/// <summary>
/// Creates the objects for the calibration of a display: the code with the time of each frame, the rendering load behind the code, and the load sweep
/// with its text.
/// </summary>
static class CalibrationObjects
{
    /// <summary>Distance of the code from the user. At this distance, its height is an eighth of the height of the headset camera's picture.</summary>
    const float DistanceMetres = 1;

    /// <summary>
    /// Angle below the line of sight. The negative value places the code above the status panel, with space for three lines of text.
    /// </summary>
    const float DegreesBelow = -6;

    /// <summary>Distance of the load behind the code. The load is therefore also behind the status panel and hides nothing.</summary>
    const float LoadBehindMetres = 0.5f;

    const float WordsAboveMetres = 0.06f;

    public static void Add(PackageAssets assets, MrilSession session)
    {
        var calibration = Children.Add("Calibration", session.transform);
        var follow = calibration.AddComponent<BodyFollow>();
        Fields.Set(follow, "_distanceMetres", DistanceMetres);
        Fields.Set(follow, "_degreesBelow", DegreesBelow);
        AddDisplay(assets, session, calibration.transform);
        AddSweep(assets, session, calibration);
    }

    static void AddDisplay(PackageAssets assets, MrilSession session, Transform parent)
    {
        var display = Children.Add("Timestamp Display", parent).AddComponent<TimestampDisplay>();
        var cell = Texts.Add(assets, "Cell", display.transform, TextAnchor.MiddleCenter, TextAlignment.Center);
        cell.gameObject.SetActive(false);
        Fields.Set(display, "_session", session);
        Fields.Set(display, "_cell", cell);
        Fields.Set(display, "_light", assets.Load<Material>(PackagePaths.Timestamp));
    }

    static void AddSweep(PackageAssets assets, MrilSession session, GameObject calibration)
    {
        var load = Children.Add("Load", calibration.transform, new Vector3(0, 0, LoadBehindMetres)).AddComponent<LoadGenerator>();
        Fields.Set(load, "_material", assets.Load<Material>(PackagePaths.Panel));
        var words = Texts.Add(assets, "Words", calibration.transform, TextAnchor.LowerCenter, TextAlignment.Center);
        words.transform.localPosition = Vector3.up * WordsAboveMetres;
        var sweep = calibration.AddComponent<LoadSweep>();
        Fields.Set(sweep, "_session", session);
        Fields.Set(sweep, "_load", load);
        Fields.Set(sweep, "_renderTime", session.GetComponent<RenderTimeSource>());
        Fields.Set(sweep, "_startOnEnable", true);
        Fields.Set(sweep, "_text", words);
    }
}
