namespace Nowpose.Web;

/// <summary>The operations page: plants, headsets, latencies and both robots. It requests all data from its gateway.</summary>
public static class OperationsPage
{
    /// <summary>Null if this assembly was built without Node.js.</summary>
    public static string Html { get; } = PageTemplate.Read("operations.html");
}
