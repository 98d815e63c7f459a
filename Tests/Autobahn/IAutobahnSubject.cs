namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>One connection to what is tested, and what it makes of what is sent.</summary>
interface IAutobahnSubject : IAsyncDisposable
{
    FramedPeer Peer { get; }

    CaseScript NewScript();

    /// <summary>"taken", "refused" … of a data frame that came back; null for one that tells nothing.</summary>
    string EventOf(string text, CaseScript script);

    /// <summary>Hands over what is seen otherwise than by frames.</summary>
    Action<string> Saw { set; }
}
