namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>A connection to the tested side. Maps its behaviour to events.</summary>
interface IAutobahnSubject : IAsyncDisposable
{
    FramedPeer Peer { get; }

    CaseScript NewScript();

    /// <summary>Gets the event of a received data frame ("accepted", "refused" …); null if the frame has no meaning in these tests.</summary>
    string EventOf(string text, CaseScript script);

    /// <summary>Sets the receiver of events that frames do not show.</summary>
    Action<string> Saw { set; }
}
