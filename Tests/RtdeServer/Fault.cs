namespace Nowpose.RtdeServer;

/// <summary>Faults that the server can simulate, by their names on the command line.</summary>
enum Fault
{
    None,

    /// <summary>The controller restarts: connections end, its clock begins at zero.</summary>
    Restart,

    /// <summary>The clock begins at zero, and connections stay.</summary>
    ClockBack,

    /// <summary>The arm and its program stop for safety.</summary>
    ProtectiveStop,

    /// <summary>The program stops.</summary>
    ProgramStop,

    /// <summary>The program runs again, and so does the arm.</summary>
    Resume,

    /// <summary>Protocol version 2 is not accepted.</summary>
    Version1,

    /// <summary>Random bytes are sent without end.</summary>
    Garbage,

    /// <summary>Half a package is sent, and nothing more.</summary>
    HalfPackages,

    /// <summary>The controller does not have the field actual_q.</summary>
    NotFound,

    /// <summary>The field actual_q has another type.</summary>
    WrongType,

    /// <summary>Each tenth package is left out.</summary>
    LostPackages,

    /// <summary>Connections are taken, and nothing is answered.</summary>
    Silent,

    /// <summary>A second client is sent away.</summary>
    OneClient,
}
