using System.Text.Json;
using Nowpose.Cli.Messages;
using Nowpose.Cli.Replay;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

/// <summary>Tests the notes of <c>replay</c> about a session: each of them is in the JSON, and a line on stderr.</summary>
public class SessionNotesTests : SessionReplayFixture
{
    async Task<string[]> NotesOf(string path, params string[] options)
    {
        var run = await Run(["replay", path, "--json", .. options]);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        using var json = JsonDocument.Parse(run.Output);
        string[] notes = json.RootElement.TryGetProperty("notes", out var list) ? list.Deserialize<string[]>() : [];
        Assert.That(run.Complaints, Is.EqualTo(notes.Select(note => ConsoleMessages.Line($"{path}: {note}"))));
        return notes;
    }

    [Test]
    public async Task Replay_SessionWithAnotherPredictor_UsesTheDefaultAndStatesTheOption()
    {
        VirtualRecording.To(_path, predictor: "linear");

        Assert.That(await NotesOf(_path), Is.EqualTo(new[] { ReplayMessages.OtherPredictor("linear") }));
        Assert.That(await NotesOf(_path, "--predictor", "linear"), Is.Empty);
        using var json = JsonDocument.Parse((await Run("replay", _path, "--json")).Output);
        Assert.That(json.RootElement.GetProperty("predictor").GetString(), Is.EqualTo(Predictors.Default));
    }

    [Test]
    public async Task Replay_SessionWithMissingLines_NotesThem()
    {
        VirtualRecording.To(_path, seconds: 10, predictor: Predictors.Default);
        await File.AppendAllTextAsync(_path, "{\"kind\":\"lost\",\"count\":12}\n");

        Assert.That(await NotesOf(_path), Is.EqualTo(new[] { SessionFileMessages.LinesLost(12) }));
    }

    // The last line is incomplete, or only the line of the end is missing.
    [TestCase(200)]
    [TestCase(33)]
    public async Task Replay_SessionWithoutItsEnd_NotesTheTimeOfTheLastEvent(int missing)
    {
        VirtualRecording.To(_path, seconds: 10, predictor: Predictors.Default);
        var text = await File.ReadAllTextAsync(_path);
        using var cut = new TemporaryFile(text[..^missing], ".jsonl");

        var end = RecordedSession.Read(cut.Path).Events[^1].At;

        Assert.That(await NotesOf(_path), Is.Empty);
        Assert.That(await NotesOf(cut.Path), Is.EqualTo(new[] { SessionFileMessages.NoEnd(end) }));
    }
}
