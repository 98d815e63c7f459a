namespace Nowpose.RtdeServer;

/// <summary>Faults that the server can simulate, by their names on the command line.</summary>
enum Fault
{
    None,

    /// <summary>The controller restarts: connections end, and its clock restarts at zero.</summary>
    Restart,

    /// <summary>The clock restarts at zero, but connections stay open.</summary>
    ClockBack,

    /// <summary>The arm and its program stop for safety.</summary>
    ProtectiveStop,

    /// <summary>The program stops.</summary>
    ProgramStop,

    /// <summary>The program and the arm run again.</summary>
    Resume,

    /// <summary>Protocol version 2 is not accepted.</summary>
    Version1,

    /// <summary>The server sends random bytes continuously.</summary>
    Garbage,

    /// <summary>The server sends half a package and then nothing.</summary>
    HalfPackages,

    /// <summary>The controller does not have the field actual_q.</summary>
    NotFound,

    /// <summary>The field actual_q has another type.</summary>
    WrongType,

    /// <summary>The server omits every tenth package.</summary>
    LostPackages,

    /// <summary>The server accepts connections but does not respond.</summary>
    Silent,

    /// <summary>The server disconnects a second client.</summary>
    OneClient,
}
