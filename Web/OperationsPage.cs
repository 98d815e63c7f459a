namespace Nowpose.Web;

/// <summary>The operations page: plants, headsets, latencies and the robot. It requests all data from the gateway that serves it.</summary>
public static class OperationsPage
{
    /// <summary>HTML text of the page; null if this assembly was built without Node.js.</summary>
    public static string Html { get; } = PageTemplate.Read("operations.html");
}
