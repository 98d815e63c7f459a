using Nowpose.Cli.Replay;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Session;

public sealed class SessionRecordingTests
{
    PlayedCell _cell;
    MrilSession _session;
    SessionRecording _recording;
    string _folder;

    [SetUp]
    public void SetUp()
    {
        _folder = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N"));
        _cell = new PlayedCell();
        _recording = null;
    }

    [TearDown]
    public async Task TearDown()
    {
        _cell.Dispose();
        // Waits until all files exist, because a file that a thread creates later would prevent the deletion of the folder.
        await Written(files: _recording?.Problem == null ? _cell.Messages.Count(line =>
            line.Contains(SessionMessages.Recording(""), StringComparison.Ordinal)) : 0);
        if (Directory.Exists(_folder)) Directory.Delete(_folder, recursive: true);
    }

    void Play(string robot = "youbot", bool recordOnEnable = true, double megabytes = 500)
    {
        _session = _cell.NewSession(robot);
        _recording = _session.gameObject.AddComponent<SessionRecording>()
            .With("_folder", _folder).With("_recordOnEnable", recordOnEnable).With("_maximumMegabytes", megabytes);
        _session.gameObject.SetActive(true);
    }

    string[] Files => Directory.Exists(_folder) ? [.. Directory.GetFiles(_folder).Order()] : [];

    // Waits for the files, because background threads create and close them.
    Task Written(int files = 0) => Soon.BecomesAsync(() => Files.Length >= files && Files.All(IsClosed), "the files are closed");

    static bool IsClosed(string file)
    {
        var lines = File.ReadAllLines(file);
        return lines.Length > 0 && lines[^1].Contains("\"end\"", StringComparison.Ordinal);
    }

    [Test]
    public async Task OnEnable_SessionRunning_WritesAReplayableFile()
    {
        var frames = 0;
        Play();
        _cell.Run(3, _session, () => frames++);
        Assert.That(_recording.IsRecording);

        _recording.StopRecording();
        await Written(files: 1);

        Assert.That(_recording.IsRecording, Is.False);
        Assert.That(Files, Is.EqualTo(new[] { _recording.Path }));
        Assert.That(System.IO.Path.GetFileName(_recording.Path), Does.Match(@"^nowpose-\d{8}T\d{9}Z\.jsonl$"));
        var session = RecordedSession.Read(_recording.Path);
        Assert.That(session.Frames, Is.EqualTo(frames));
        var result = new SessionReplay(_recording.Path, session, new SessionTruth(session), new ReplaySettings()).Run();
        Assert.That(result.Frames, Is.GreaterThan(100));
    }

    [Test]
    public void Inspector_WhileRecording_ShowsTheStateAndTheFile()
    {
        Play();
        _cell.Run(3, _session);
        UnityEditor.GuiRecorder.Clear();
        var editor = UnityEditor.Editor.CreateEditor(_recording);

        editor.OnInspectorGUI();

        Assert.That(UnityEditor.GuiRecorder.Texts, Does.Contain("State: recording").And.Contain("File: " + _recording.Path));
        UnityEngine.Object.DestroyImmediate(editor);
    }

    [Test]
    public void Frames_WhileRecording_AllocateNothing()
    {
        Play();
        _cell.Run(3, _session);
        _recording.enabled = false;
        _cell.Run(1, _session);
        var without = _cell.AllocatedIn(() => _cell.Run(3, _session));

        _recording.enabled = true;
        _cell.Run(1, _session);
        var allocated = _cell.AllocatedIn(() => _cell.Run(3, _session));

        Assert.That(_recording.IsRecording);
        Assert.That(allocated, Is.EqualTo(without));
    }

    [Test]
    public void Problem_OfAnEarlierFile_DoesNotRemain()
    {
        Play();
        _recording.With("_maximumMegabytes", -1.0);
        Restart();
        Assert.That((_recording.IsRecording, _recording.Problem != null), Is.EqualTo((false, true)));

        _recording.With("_maximumMegabytes", 500.0);
        Restart();

        Assert.That((_recording.IsRecording, _recording.Problem), Is.EqualTo((true, (string)null)));
    }

    // The application pauses; the next session has a file of its own.
    void Restart()
    {
        _cell.Player.Pause(true);
        _cell.Player.Pause(false);
        _cell.Run(0.1, _session);
    }

    [Test]
    public void RecordOnEnable_Off_WritesNothingUntilStarted()
    {
        Play(recordOnEnable: false);
        _cell.Run(0.5, _session);
        Assert.That(Files, Is.Empty);
        Assert.That(_recording.Path, Is.Null);

        _recording.StartRecording();
        _cell.Run(0.5, _session);

        Assert.That(_recording.IsRecording);
    }

    [Test]
    public async Task Pause_ApplicationPaused_EndsTheFileAndStartsAnother()
    {
        Play();
        _cell.Run(1, _session);
        var first = _recording.Path;

        // On a headset, no frame follows: the system may end the application during the pause.
        _cell.Player.Pause(true);
        Assert.That(_recording.IsRecording, Is.False);
        await Written(files: 1);
        _cell.Player.Pause(false);
        _cell.Run(1, _session);
        _recording.enabled = false;
        await Written(files: 2);

        Assert.That(Files, Is.EqualTo(new[] { first, _recording.Path }));
    }

    [Test]
    public void Robot_Unknown_DelaysTheStart()
    {
        Play(robot: null);
        _cell.Run(0.5, _session);
        Assert.That(_recording.IsRecording, Is.False);

        _session.Session.Described(RobotFiles.LoadText("ur5"));
        _cell.Run(0.5, _session);

        Assert.That(_recording.IsRecording);
    }

    [Test]
    public void Robot_UnknownInACellWithObjects_DoesNotDelayTheStart()
    {
        Play(robot: null);
        _session.Session.Frames.Need("fixture");
        _session.Session.Frames.Place("fixture", RigidTransform.Identity);

        _cell.Run(0.5, _session);

        Assert.That(_recording.IsRecording);
    }

    [Test]
    public async Task File_CannotBeCreated_IsLoggedOnceAndTheSessionContinues()
    {
        File.WriteAllText(_folder, "a file where the folder should be");
        try
        {
            Play();
            _cell.Run(0.1, _session);
            await Soon.BecomesAsync(() => !_recording.IsRecording, "the recording has failed");
            _cell.Run(3, _session);

            Assert.That(_recording.Problem, Does.StartWith(RecordingMessages.Stopped(_recording.Path, "")));
            Assert.That(_cell.Messages, Has.Exactly(1).EndsWith(_recording.Problem));
            Assert.That(_session.Frame.State, Is.EqualTo(Nowpose.Session.PoseState.Current).Or.EqualTo(Nowpose.Session.PoseState.Unsynchronised));
            Assert.That(_session.Frame.DisplayTime, Is.Not.Null);
        }
        finally
        {
            File.Delete(_folder);
        }
    }

    [Test]
    public async Task File_AtItsMaximumSize_IsLoggedOnceAndTheSessionContinues()
    {
        Play(megabytes: 0.02);
        _cell.Run(2, _session);
        await Soon.BecomesAsync(() => !_recording.IsRecording, "the file is full");
        _cell.Run(3, _session);

        Assert.That(_recording.Problem, Is.EqualTo(RecordingMessages.MaxSize(_recording.Path, "0.02")));
        Assert.That(_cell.Messages, Has.Exactly(1).EndsWith(_recording.Problem));
        Assert.That(Files, Has.Length.EqualTo(1), "no second file is created");
        Assert.That(_session.Session.Intake.HasSampleHandler, Is.False, "messages are reused");
        Assert.That(_session.Frame.State, Is.EqualTo(Nowpose.Session.PoseState.Current));
    }

    [Test]
    public void Size_OutOfRange_IsLoggedOnce()
    {
        Play(megabytes: -1);

        _cell.Run(0.5, _session);

        Assert.That(_recording.Problem, Is.EqualTo(ComponentMessages.Of(
            "session recording", "Cell", SettingMessages.OutOfRange(SettingNames.MaxRecordingSize, -1, " MB", 0.001, 100_000))));
        Assert.That(_cell.Messages, Has.Exactly(1).EndsWith(_recording.Problem));
    }

    [Test]
    public void Session_Missing_IsLogged()
    {
        var alone = new GameObject("Alone").AddComponent<SessionRecording>();

        _cell.Run(0.1, null);

        Assert.That(_cell.Messages, Has.Some.Contains("'Alone' " + ComponentMessages.NoSession));
        Assert.That(alone.IsRecording, Is.False);
    }
}
