using System.CommandLine;
using System.Text.RegularExpressions;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

public partial class CommandLineTests
{
    [TestCase("sync", "x.csv", "--nope")]
    [TestCase("sync", "x.csv", "--estimator")]
    [TestCase("sync", "x.csv", "--estimator", "magic")]
    [TestCase("sync")]
    [TestCase("frobnicate")]
    [TestCase("--seconds", "5", "demo")]
    [TestCase("demo", "--seed", "1.5")]
    public async Task Run_InvalidArguments_PrintsOneLineAndExitsWith2(params string[] args)
    {
        var run = await CliRun.OfAsync(args);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Output, Is.Empty);
        Assert.That(run.Complaints, Has.Length.EqualTo(1));
        Assert.That(run.Errors, Does.StartWith("nowpose: "));
    }

    [TestCase("--bogus")]
    [TestCase("--seconds", "5", "--bogus=3")]
    public async Task Run_UnknownOption_RefersToTheHelpOnce(params string[] options)
    {
        var run = await CliRun.OfAsync(["demo", .. options]);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo(ConsoleMessages.Line(OptionMessages.UnknownArgument(options[^1]))));
    }

    [TestCase("demo --out --seconds 5", "--out")]
    [TestCase("demo --out --bogus", "--out")]
    [TestCase("headset --namespace ", "--namespace")]
    [TestCase("calibrate simulate --pictures 2 --out --check", "--out")]
    [TestCase("calibrate range x.csv --device --json", "--device")]
    [TestCase("headset --name --json", "--name")]
    [TestCase("replay x.csv --sampling-ms= --json", "--sampling-ms")]
    [TestCase("replay x.csv --json --sampling-ms", "--sampling-ms")]
    [TestCase("replay x.csv --seed --sampling-ms=5", "--seed")]
    [TestCase("unity . --sample --check", "--sample")]
    public async Task Run_OptionInsteadOfAValue_NamesTheOption(string line, string option)
    {
        var run = await CliRun.OfAsync(line.Split(' '));

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo(ConsoleMessages.Line(OptionMessages.ValueMissing(option))));
    }

    [TestCase("sync none.csv --at=--json")]
    [TestCase("sync none.csv --page --json")]
    [TestCase("replay none.csv --seed -5")]
    public async Task Run_ValueThatBeginsWithAHyphen_IsAccepted(string line)
    {
        var run = await CliRun.OfAsync(line.Split(' '));

        Assert.That(run.Errors.TrimEnd(), Is.EqualTo(ConsoleMessages.Line(PathMessages.NotFound(line.Split(' ')[1]))));
    }

    [Test]
    public async Task Run_FileNameThatBeginsWithAnAt_IsThatFile()
    {
        using var folder = new TemporaryFolder();
        var arguments = Path.Combine(folder.Path, "arguments.txt");
        await File.WriteAllTextAsync(arguments, "--bogus");

        var run = await CliRun.OfAsync("replay", "@" + arguments);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo(ConsoleMessages.Line(PathMessages.NotFound("@" + arguments))));
    }

    [Test]
    public async Task Run_UnknownCommandWithHelp_ExitsWith2()
    {
        var run = await CliRun.OfAsync("bogus", "--help");

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Output, Is.Empty);
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo(ConsoleMessages.Line(OptionMessages.UnknownArgument("bogus"))));
    }

    [Test]
    public async Task Run_FileMissing_NamesTheFile()
    {
        var run = await CliRun.OfAsync("sync", "no-such-file.csv");

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo(ConsoleMessages.Line(PathMessages.NotFound("no-such-file.csv"))));
    }

    [Test, Platform(Exclude = "Win")]
    public async Task Run_ErrorOutputIsClosed_ExitsWith2()
    {
        using var program = PeerProcess.OfShell($"exec dotnet '{Path.Combine(AppContext.BaseDirectory, "Nowpose.Cli.dll")}' sync no-such-file.csv 2>&-");

        Assert.That(await program.EndsAsync(), Is.EqualTo(2));
    }

    [TestCase("--help")]
    [TestCase("sync", "--help")]
    public async Task Run_HelpOption_PrintsTheHelp(params string[] args)
    {
        var run = await CliRun.OfAsync(args);

        Assert.That(run.ExitStatus, Is.EqualTo(0));
        Assert.That(run.Output.ReplaceLineEndings("\n"), Does.Contain("Usage:\n  nowpose "));
    }

    [TestCase("command-line.md")]
    [TestCase("gateway.md")]
    public void Create_Commands_AreThoseInTheTableOfTheManual(string page)
    {
        var rows = RepositoryFiles.Read($"{RepositoryFiles.Package}/Documentation~/{page}").Split('\n')
            .SkipWhile(line => line != "| Command | Purpose |").Skip(2).TakeWhile(line => line.StartsWith('|'));

        var listed = rows.SelectMany(row => ListedCommand().Matches(row.Split('|')[1])).Select(match => match.Groups[1].Value);

        Assert.That(listed, Is.EquivalentTo(ProgramOf(page).Subcommands.Select(command => command.Name)), $"each command needs a row in the table of {page}");
    }

    [TestCase("command-line.md")]
    [TestCase("gateway.md")]
    public void Create_Options_AreInTheManual(string page)
    {
        var manual = string.Concat(RepositoryFiles.Under($"{RepositoryFiles.Package}/Documentation~", ".md").Select(RepositoryFiles.Read));

        var missing = WithSubcommands(ProgramOf(page)).SelectMany(command => command.Options).Where(option => !option.Hidden).Select(option => option.Name)
            .Distinct().Where(name => !Regex.IsMatch(manual, name + @"(?![\w-])"));

        Assert.That(missing, Is.Empty, "describe each option on a page of the manual");
    }

    static Command ProgramOf(string page) =>
        page == "gateway.md" ? Nowpose.Gateway.CommandLine.Create(new ConfiguredArguments()) : Nowpose.Cli.CommandLine.Create();

    static IEnumerable<Command> WithSubcommands(Command command) => command.Subcommands.SelectMany(WithSubcommands).Prepend(command);

    [GeneratedRegex(@"`([\w-]+)[^`]*`")]
    private static partial Regex ListedCommand();
}
