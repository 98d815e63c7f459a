namespace Nowpose.Web;

/// <summary>The page that shows the control clock as a code for cameras. It requests the time from its gateway.</summary>
public static class LightCodePage
{
    /// <summary>Null if this assembly was built without Node.js.</summary>
    public static string Html { get; } = PageTemplate.Read("vlc.html");
}
