namespace Nowpose.Web;

/// <summary>The page of operations: plants, headsets, latencies, both robots; it asks the gateway it came from for all of it.</summary>
public static class OperationsPage
{
    /// <summary>Null when Node.js was missing where this assembly was built.</summary>
    public static string Html { get; } = PageTemplate.Read("operations.html");
}
