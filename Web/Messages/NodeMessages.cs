namespace Nowpose.Web.Messages;

/// <summary>Error messages about scripts that Node.js runs, with remedies.</summary>
static class NodeMessages
{
    public static string NotBuilt(string needed) => $"{needed}; this program was built without it: install it and build again";
    public static string NotStarted(string needed, string reason) => $"{needed}; it could not be started: {reason}. Install it from nodejs.org";
}
