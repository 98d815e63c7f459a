using Nowpose.Recording;
using Nowpose.Session;

namespace Nowpose.Cli.Demo;

/// <summary>The recording of the headset's session. Without a path, it does nothing.</summary>
/// <param name="path">Path of the file; null to record nothing.</param>
/// <param name="startedUtc">Start time for the header; null to omit it.</param>
sealed class DemoRecording(string path, DateTime? startedUtc) : IDisposable
{
    SessionRecorder _recorder;

    /// <summary>Starts to record a session. It replaces the recording of the previous session.</summary>
    public void Start(CompensationSession session)
    {
        // In a scene for any robot, the first session has no joints. It is not recorded.
        if (path == null || session.Robot.MovingJoints.Count == 0) return;
        End();
        _recorder = new SessionRecorder(session, new RecordingSettings(path, startedUtc: startedUtc));
    }

    /// <summary>Waits until everything recorded so far is written.</summary>
    public void Flush() => _recorder?.FlushAsync().Wait();

    /// <summary>Ends the recording and waits until its last line is written.</summary>
    /// <returns>The reason if the recording ended early, otherwise null; and the number of lost lines.</returns>
    public (string Problem, long LostLines) End()
    {
        _recorder?.Dispose();
        _recorder?.Ended.Wait();
        return (_recorder?.Problem, _recorder?.LostLines ?? 0);
    }

    public void Dispose() => _recorder?.Dispose();
}
