Nowpose.Gateway.Options.WindowsProcess.SetUp();
Nowpose.Gateway.Options.GuardedConsole.Set();
return await Nowpose.Cli.CommandLine.RunAsync(args);
