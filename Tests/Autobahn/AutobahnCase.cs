namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>One case of the Autobahn test suite, in the notation of these tests.</summary>
/// <param name="Number">Number of the case in the suite.</param>
/// <param name="Expected">
/// Expected events in any order: "accepted" for each accepted message; "refused" for a message that the protocol does not use, if the connection
/// stays open after it; "pong"; "close:CODE" or "close". "|" separates alternative results.
/// </param>
/// <param name="Play">Sends the frames of the case.</param>
public sealed record AutobahnCase(string Number, string Expected, Action<object> Play)
{
    /// <summary>Whether the case ends the connection.</summary>
    public bool Ends => Expected.Contains("close");

    public override string ToString() => Number;
}
