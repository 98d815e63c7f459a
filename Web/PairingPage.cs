namespace Nowpose.Web;

/// <summary>The page that shows the code for pairing a headset and prints markers. It requests both from the gateway that serves it.</summary>
public static class PairingPage
{
    /// <summary>HTML text of the page; null if this assembly was built without Node.js.</summary>
    public static string Html { get; } = PageTemplate.Read("pairing.html");
}
