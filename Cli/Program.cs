Nowpose.Gateway.Options.GuardedConsole.Set();
return await Nowpose.Cli.CommandLine.RunAsync(args);
