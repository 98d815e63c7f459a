namespace Nowpose.Web;

/// <summary>The page that shows the code which pairs a headset, and prints markers; it asks the gateway it came from for both.</summary>
public static class PairingPage
{
    /// <summary>Null when Node.js was missing where this assembly was built.</summary>
    public static string Html { get; } = PageTemplate.Read("pairing.html");
}
