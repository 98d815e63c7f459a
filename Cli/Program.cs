return await Nowpose.Cli.CommandLine.RunAsync(args);
