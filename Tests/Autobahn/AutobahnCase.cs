namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>One case of the Autobahn test-suite in our notation.</summary>
/// <param name="Number">The suite's case number.</param>
/// <param name="Expected">
/// Expected events in any order: "accepted" for each accepted message, "refused" for a message that our protocol does not use and after which
/// the connection continues, "pong", "close:CODE" or "close". Equivalent outcomes are separated by "|".
/// </param>
/// <param name="Play">Sends the case's frames.</param>
public sealed record AutobahnCase(string Number, string Expected, Action<object> Play)
{
    /// <summary>Whether the case ends the connection.</summary>
    public bool Ends => Expected.Contains("close");

    public override string ToString() => Number;
}
