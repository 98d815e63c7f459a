namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>One connection to the tested side, and the events that its behaviour is mapped to.</summary>
interface IAutobahnSubject : IAsyncDisposable
{
    FramedPeer Peer { get; }

    CaseScript NewScript();

    /// <summary>Returns the event of a received data frame ("accepted", "refused" …); null for a frame without meaning here.</summary>
    string EventOf(string text, CaseScript script);

    /// <summary>Sets the receiver of events that are not observed through frames.</summary>
    Action<string> Saw { set; }
}
