namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>A connection to the system under test. Maps the behaviour of the system to events.</summary>
interface IAutobahnSubject : IAsyncDisposable
{
    FramedPeer Peer { get; }

    CaseScript NewScript();

    /// <summary>
    /// Returns the event for a received data frame, such as "accepted" or "refused"; null if the frame has no meaning in these tests.
    /// </summary>
    string EventOf(string text, CaseScript script);

    /// <summary>Sets the receiver of events that cannot be derived from received frames.</summary>
    Action<string> Saw { set; }
}
