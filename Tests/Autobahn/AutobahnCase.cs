namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>One case of the Autobahn test-suite, in our words.</summary>
/// <param name="Number">The suite's.</param>
/// <param name="Expected">
/// What has to come of it, in any order: "taken" for each message, "refused" for a message that our protocol has no use for and the connection
/// bears, "pong", "close:CODE" or "close". Ways that are as good are separated by "|".
/// </param>
/// <param name="Play">What is sent.</param>
public sealed record AutobahnCase(string Number, string Expected, Action<object> Play)
{
    /// <summary>Whether the connection is over after it.</summary>
    public bool Ends => Expected.Contains("close");

    public override string ToString() => Number;
}
