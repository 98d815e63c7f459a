using System.Collections.Generic;

namespace Nowpose.Unity.Cell
{
    /// <summary>An object, a signal or an additional robot of the cell that a component shows.</summary>
    interface IShownPart
    {
        /// <summary>Kind and name of the part, such as "object workpiece_1".</summary>
        string Title { get; }

        /// <summary>Reason why the part is not current, in one line; null if it is current.</summary>
        string Fault { get; }
    }

    /// <summary>
    /// Lists the objects, signals and other robots of the cell that components show, with the faults of the parts that are not current.
    /// </summary>
    sealed class ShownParts
    {
        readonly List<IShownPart> _parts = new List<IShownPart>();
        readonly List<string> _objects = new List<string>();
        readonly List<(string Title, string Fault)> _faults = new List<(string, string)>();
        int _count = -1;

        public int Count => _parts.Count;

        /// <summary>Frame names of the shown objects. A frame that two objects show is listed twice.</summary>
        public IReadOnlyList<string> Objects => _objects;

        /// <summary>Number of parts that were not current at the last <see cref="Update"/>.</summary>
        public int FaultCount => _faults.Count;

        /// <summary>
        /// Summary of the parts, such as "3 current" or, if some parts are not current, "! 2 not current"; empty without parts. It is the
        /// same string object until one of these numbers changes.
        /// </summary>
        public string Summary { get; private set; } = "";

        /// <summary>Returns the title of a part that was not current at the last <see cref="Update"/>.</summary>
        /// <param name="index">0 to <see cref="FaultCount"/> − 1.</param>
        public string FaultyTitle(int index) => _faults[index].Title;

        /// <summary>Returns the reason why this part was not current, in one line.</summary>
        public string FaultOf(int index) => _faults[index].Fault;

        public void Add(IShownPart part) => _parts.Add(part);

        public void Remove(IShownPart part) => _parts.Remove(part);

        /// <summary>Adds an object that is shown at a frame. A gripper can grip this object when it is within reach.</summary>
        public void Add(IShownPart part, string frame)
        {
            Add(part);
            _objects.Add(frame);
        }

        public void Remove(IShownPart part, string frame)
        {
            Remove(part);
            _objects.Remove(frame);
        }

        /// <summary>Reads the faults of all parts. Allocates only when their number or the number of parts has changed.</summary>
        public void Update()
        {
            var former = _faults.Count;
            _faults.Clear();
            foreach (var part in _parts)
                if (part.Fault is string fault) _faults.Add((part.Title, fault));
            if (_count == _parts.Count && former == _faults.Count) return;
            _count = _parts.Count;
            Summary = _count == 0 ? "" : _faults.Count == 0 ? _count + " current" : "! " + _faults.Count + " not current";
        }
    }
}
