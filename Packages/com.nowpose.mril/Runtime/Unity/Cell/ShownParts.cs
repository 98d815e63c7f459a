using System.Collections.Generic;
using Nowpose.Unity.Messages;

namespace Nowpose.Unity.Cell
{
    /// <summary>An object, a signal or an additional robot of the cell that a component shows.</summary>
    interface IShownPart
    {
        /// <summary>Kind and name of the part, such as "object workpiece_1".</summary>
        string Title { get; }

        /// <summary>Reason why the part is not current, in one line; null if it is current.</summary>
        string Fault { get; }

        /// <summary>
        /// Whether the reason affects all parts alike: the display time is not known well enough, or the render time is outside its range. The status
        /// panel shows this reason once.
        /// </summary>
        bool IsFaultCommon { get; }

        /// <summary>Control time since which the part has not been current; null while unknown.</summary>
        ControlTime? FaultSince { get; }
    }

    /// <summary>
    /// Lists the objects, signals and other robots of the cell that components show, with the faults of the parts that are not current, the most
    /// severe first.
    /// </summary>
    sealed class ShownParts
    {
        readonly List<IShownPart> _parts = new List<IShownPart>();
        readonly List<string> _grippable = new List<string>();
        readonly List<(string Title, string Fault, ControlTime? Since)> _faults = new List<(string, string, ControlTime?)>();
        int _count = -1, _notCurrent;

        public int Count => _parts.Count;

        /// <summary>Frame names of the shown objects that a gripper can grip. A frame that two objects show is listed twice.</summary>
        public IReadOnlyList<string> Grippable => _grippable;

        /// <summary>Number of parts that had a fault of their own at the last <see cref="Update"/>.</summary>
        public int FaultCount => _faults.Count;

        /// <summary>
        /// Summary of the parts, such as "3 current" or, if some parts are not current, "! 2 not current"; empty without parts. It is the
        /// same string object until one of these numbers changes.
        /// </summary>
        public string Summary { get; private set; } = "";

        /// <summary>Returns the title of a part that had a fault of its own at the last <see cref="Update"/>.</summary>
        /// <param name="index">0 to <see cref="FaultCount"/> − 1.</param>
        public string FaultyTitle(int index) => _faults[index].Title;

        /// <summary>Returns the reason why this part was not current, in one line.</summary>
        public string FaultOf(int index) => _faults[index].Fault;

        /// <summary>Returns the control time since which this part has not been current; null while unknown.</summary>
        public ControlTime? SinceOf(int index) => _faults[index].Since;

        public void Add(IShownPart part) => _parts.Add(part);

        public void Remove(IShownPart part) => _parts.Remove(part);

        /// <summary>Adds an object.</summary>
        /// <param name="grippable">Name of its frame if a gripper can grip the object when it is within reach; otherwise null.</param>
        public void Add(IShownPart part, string grippable)
        {
            Add(part);
            if (grippable != null) _grippable.Add(grippable);
        }

        public void Remove(IShownPart part, string grippable)
        {
            Remove(part);
            if (grippable != null) _grippable.Remove(grippable);
        }

        /// <summary>Reads the faults of all parts. Allocates only when their number or the number of parts has changed.</summary>
        public void Update()
        {
            var former = _notCurrent;
            _notCurrent = 0;
            _faults.Clear();
            foreach (var part in _parts)
            {
                if (!(part.Fault is string fault)) continue;
                _notCurrent++;
                if (!part.IsFaultCommon) AddFault((part.Title, fault, part.FaultSince));
            }
            if (_count == _parts.Count && former == _notCurrent) return;
            _count = _parts.Count;
            Summary = _count == 0 ? "" : _notCurrent == 0 ? _count + " current" : StatusMessages.NotCurrent(_notCurrent);
        }

        // Parts whose time is unknown come first, for example those without data yet, then those that failed last, as in the diagnostics. Otherwise, the
        // order is that of the scene.
        // List.Sort is not stable, and allocates on Mono.
        void AddFault((string Title, string Fault, ControlTime? Since) fault)
        {
            var index = _faults.Count;
            while (index > 0 && IsBefore(fault.Since, _faults[index - 1].Since)) index--;
            _faults.Insert(index, fault);
        }

        static bool IsBefore(ControlTime? a, ControlTime? b) => b.HasValue && !(a <= b);
    }
}
