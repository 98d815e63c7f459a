return await Nowpose.Gateway.CommandLine.RunAsync(args);
