using System.Text;
using Nowpose.Frames;
using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Security;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Pairing;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>Feeds a quarter of a million malformed inputs to all readers of external data. Each must be read correctly or rejected with the right error.</summary>
[NonParallelizable] // measures the memory of the whole process
public class ReaderFuzzTests
{
    // The inputs are the same in each run, so more of them would mostly repeat the same kinds of damage.
    const int Messages = 95_000, Bytes = 25_000, Frames = 75_000, Exchanges = 25_000, Codes = 7_500, Robots = 5_000, Profiles = 5_000,
        Configurations = 5_000, Pairings = 2_250, Tokens = 250, StationaryPoses = 2_500, Bodies = 2_500;

    [Test]
    public void TryRead_DamagedMessages_AcceptsOnlyValidMessages()
    {
        var accepted = new FuzzRun("rosbridge messages", 1, Messages).Feed<string>(() => new TextMutator(Seeds.Messages).Next, () =>
        {
            var reader = new RosbridgeReader();
            return text => MessageRules.IsTaken(reader, Encoding.UTF8.GetBytes(text));
        });

        Assert.That(accepted, Is.InRange(Messages / 20, Messages / 20 * 19), "the messages include valid and invalid ones");
    }

    [Test]
    public void TryRead_DamagedBytes_AcceptsOnlyValidMessages()
    {
        var accepted = new FuzzRun("rosbridge bytes", 10, Bytes).Feed<byte[]>(() => NextBytes, () =>
        {
            var reader = new RosbridgeReader();
            return utf8 => MessageRules.IsTaken(reader, utf8);
        });

        Assert.That(accepted, Is.InRange(Bytes / 20, Bytes / 20 * 19), "the messages include valid and invalid ones");

        static byte[] NextBytes(Random random)
        {
            var bytes = Encoding.UTF8.GetBytes(Seeds.Messages[random.Next(Seeds.Messages.Length)].Replace("\"a\"", "\"aé€🤖\""));
            for (var n = random.Next(4); n > 0; n--) bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
            return bytes;
        }
    }

    [Test]
    public void SyncFrame_DamagedFrames_AcceptsOnlyFramesThatRoundTrip()
    {
        var accepted = new FuzzRun("sync frames", 2, Frames).Feed<byte[]>(() => FrameMutator.Next, () => bytes =>
        {
            if (!SyncFrame.TryRead(bytes, out var frame, out var fault))
                return fault == SyncFrameFault.None ? throw new FuzzException("refused without a reason") : false;
            var again = new byte[SyncFrame.Size];
            frame.Write(again);
            SyncToken.TryReadLength(bytes.AsSpan(0, SyncToken.LengthSize), out _);
            SyncToken.TryReadText(bytes, out _);
            return SyncFrame.TryRead(again, out var second, out _)
                && second.Equals(frame) ? true : throw new FuzzException("reads otherwise than written");
        });

        Assert.That(accepted, Is.InRange(Frames / 20, Frames / 20 * 19));
    }

    [Test]
    public void ClockSynchroniser_RandomReplies_KeepsTheEstimateValid()
    {
        var accepted = new FuzzRun("sync replies", 3, Exchanges).Feed<int>(() => random => random.Next(), () => new WildServer().Reply);

        Assert.That(accepted, Is.GreaterThan(Exchanges / 100));
    }

    [Test]
    public void PairingCode_DamagedText_IsParsedOrRejectedWithAOneLineMessage() => Refused("pairing codes", 4, Codes, Seeds.Codes, text =>
    {
        var code = CellCode.Parse(text);
        MessageRules.Finite(code.SizeMetres);
        if (code.Marker == null) return;
        foreach (var number in code.Marker.ToPose().ToRowMajor16()) MessageRules.Finite(number);
    });

    [Test]
    public void Urdf_DamagedText_IsRejectedOrGivesPoses() => Refused("robot descriptions", 5, Robots, Seeds.Robots, text =>
    {
        var robot = UrdfReader.Read(text, "fuzz");
        var poses = new RigidTransform[robot.Links.Count];
        new ForwardKinematics(robot).Compute(new double[robot.MovingJoints.Count], poses);
        foreach (var pose in poses)
            foreach (var number in pose.ToRowMajor16()) MessageRules.Finite(number);
    });

    [Test]
    public void LatencyProfile_DamagedText_IsRejectedOrFinite() => Refused("latency profiles", 6, Profiles, [Seeds.Profile], text =>
    {
        var profile = LatencyProfileJson.Read(text, "fuzz");
        MessageRules.Finite(profile.Visualisation.Length.TotalSeconds);
        if (profile.WatchedRange != null) MessageRules.Finite(profile.WatchedRange.Limit.TotalSeconds);
    });

    [Test]
    public void Configuration_DamagedText_IsReadOrNamesTheLineOfEachFault()
    {
        var accepted = new FuzzRun("configurations", 9, Configurations).Feed<string>(() => new TextMutator(Seeds.Configurations).Next, () => text =>
        {
            var wrong = new InvalidEntries();
            ConfigurationFile.Parse(text, "fuzz", wrong);
            foreach (var line in wrong.Lines)
                if (!line.StartsWith("fuzz:",
                    StringComparison.Ordinal) || !char.IsAsciiDigit(line[5])) throw new FuzzException("a fault without its line: " + line);
            return wrong.Lines.Count == 0;
        });

        Assert.That(accepted, Is.InRange(1, Configurations - 1), "the messages include valid and invalid ones");
    }

    [Test]
    public void TokenFile_DamagedText_IsRejectedWithoutPrintingTokens()
    {
        using var folder = new TemporaryFolder();

        Refused("token files", 7, Tokens, Seeds.Tokens, text =>
        {
            TokenList.Read(FileOf(folder, ".txt", text));
        }, secrets: ["4f5a6b7c8d9e", "0123456789abcdef", "s3cret-operator"]);
    }

    [Test]
    public void PairedHeadsets_DamagedLines_AreRejectedOrRoundTrip()
    {
        new FuzzRun("lists of paired headsets", 8, Pairings).Feed<string>(() => new TextMutator(Seeds.Paired).Next, () => text =>
        {
            var taken = false;
            foreach (var line in text.Split('\n'))
            {
                if (PairedHeadset.Read(line.Trim()) is not { } headset) continue;
                if (PairedHeadset.Read(headset.ToString()) is not { } again || !again.Hash.AsSpan().SequenceEqual(headset.Hash))
                    throw new FuzzException("reads otherwise than written");
                taken = true;
            }
            return taken;
        });
    }

    [Test]
    public void StationaryFrames_DamagedFile_IsRejectedOrFinite()
    {
        using var folder = new TemporaryFolder();

        Refused("stationary frames", 12, StationaryPoses, [Seeds.StationaryFrames], text =>
        {
            var message = StationaryFrames.Load(FileOf(folder, ".json", text));
            for (var i = 0; i < message.Count; i++)
                foreach (var number in message[i].ToPose().ToRowMajor16()) MessageRules.Finite(number);
        });
    }

    [Test]
    public void BodyRecording_DamagedFile_IsRejectedOrHasUnitQuaternionsAndIncreasingTimes()
    {
        using var folder = new TemporaryFolder();

        Refused("recordings of bodies", 13, Bodies, [Seeds.Body], text =>
        {
            var recording = MotionRecording.Read(FileOf(folder, ".csv", text));
            for (var row = 1; row < recording.Times.Count; row++)
                if (!(recording.Times[row] > recording.Times[row - 1])) throw new FuzzException("times do not increase");
            var positions = Enumerable.Range(0, recording.Names.Count).Select(recording.PositionsOf).ToArray();
            foreach (var column in positions)
                foreach (var number in column) MessageRules.Finite(number);
            if (!recording.IsBody) return;
            for (var row = 0; row < recording.Times.Count; row++)
                if (!UnitQuaternion.TryNormalise(positions[3][row], positions[4][row], positions[5][row], positions[6][row], out _))
                    throw new FuzzException("a quaternion is not a unit quaternion");
        });
    }

    // Each thread writes a file of its own.
    static string FileOf(TemporaryFolder folder, string extension, string text)
    {
        var path = Path.Combine(folder.Path, Environment.CurrentManagedThreadId + extension);
        File.WriteAllBytes(path, Encoding.UTF8.GetBytes(text));
        return path;
    }

    // Invalid input must cause an InputException whose message is a single line.
    static void Refused(string name, int seed, int inputs, string[] seeds, Action<string> read, params string[] secrets)
    {
        var accepted = new FuzzRun(name, seed, inputs).Feed<string>(() => new TextMutator(seeds).Next, () => text =>
        {
            try
            {
                read(text);
                return true;
            }
            catch (InputException refusal)
            {
                if (refusal.Message.Length > 1000 || refusal.Message.Any(char.IsControl))
                    throw new FuzzException("refused with more than a line: " + refusal.Message);
                if (secrets.Any(refusal.Message.Contains)) throw new FuzzException("a secret is shown: " + refusal.Message);
                return false;
            }
        });

        Assert.That(accepted, Is.InRange(1, inputs - 1), "the messages include valid and invalid ones");
    }
}
