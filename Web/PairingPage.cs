namespace Nowpose.Web;

/// <summary>The page that shows the code that pairs a headset, and prints markers. It requests both from its gateway.</summary>
public static class PairingPage
{
    /// <summary>Null if this assembly was built without Node.js.</summary>
    public static string Html { get; } = PageTemplate.Read("pairing.html");
}
