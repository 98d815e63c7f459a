namespace Nowpose.Web;

/// <summary>The VLC page, which shows the control time as a code for cameras. It requests the time from the gateway that serves it.</summary>
public static class VlcPage
{
    /// <summary>HTML text of the page; null if this assembly was built without Node.js.</summary>
    public static string Html { get; } = PageTemplate.Read("vlc.html");
}
