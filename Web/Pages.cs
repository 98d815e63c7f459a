namespace Nowpose.Web;

/// <summary>The web pages. Those without data of their own request them from the gateway that serves them.</summary>
public static class Pages
{
    /// <summary>The report of a run. Its data have the fields of <c>Web/src/data.ts</c>; each can be null or missing.</summary>
    public static DataPage Report { get; } = new("report.html", PlainReport.Render);

    /// <summary>The paper's figures. Their data have the fields of <c>Web/src/figures/data.ts</c>.</summary>
    public static DataPage Figures { get; } = new("figures.html", PlainFigures.Render);

    /// <summary>The result of a calibration. Its data have the fields of <c>Web/src/calibration/data.ts</c>.</summary>
    public static DataPage Calibration { get; } = new("calibration.html", PlainCalibration.Render);

    /// <summary>The operations page: plants, headsets, latencies and the robot; null if this assembly was built without Node.js.</summary>
    public static string Operations { get; } = DataPage.Read("operations.html");

    /// <summary>The code for pairing a headset, and markers to print; null if this assembly was built without Node.js.</summary>
    public static string Pairing { get; } = DataPage.Read("pairing.html");

    /// <summary>The control time as a code for cameras; null if this assembly was built without Node.js.</summary>
    public static string Vlc { get; } = DataPage.Read("vlc.html");
}
