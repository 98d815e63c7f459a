namespace Nowpose.Web;

/// <summary>The page that shows the control clock as a code for cameras; it asks the gateway it came from for the time.</summary>
public static class LightCodePage
{
    /// <summary>Null when Node.js was missing where this assembly was built.</summary>
    public static string Html { get; } = PageTemplate.Read("vlc.html");
}
